#pragma once

#include <array>

#include "fem/p1.h"
#include "fem/problem.h"

namespace parmesan {

/// Integrals of f phi_0, f phi_1, f phi_2 over a triangle; with the divergence form, of r phi_i + q.grad phi_i.
using SourceMoments = std::array<double, 3>;

/// What the degree 4 rule says about a triangle or a part of one.
struct SourceSample {
  SourceMoments moments{};
  double magnitude = 0.0;      // integral of |f|, or what stands for it
  double orbit_error = 0.0;    // difference of the integrals over the two orbits of three points
  double spread = 0.0;         // of f, largest less smallest, times the area
  double corner_spread = 0.0;  // the same with the points beside the corners
};

/// A part of an element, its corners in the barycentric coordinates of the element.
struct TrianglePart {
  std::array<Barycentric, 3> corners{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double share = 1.0;  // of the element's area
};

/// Four parts of equal area.
std::array<TrianglePart, 4> subdivide(const TrianglePart& part);

/// The source on one element.
class ElementSource {
 public:
  ElementSource(const Problem& problem, const P1Element& element, int region, bool with_corners)
      : problem_(problem), element_(element), region_(region), with_corners_(with_corners) {}

  SourceSample sample(const TrianglePart& part) const;

 private:
  double beside_corner(const TrianglePart& part, std::size_t i) const;
  void add_flux(const TrianglePart& part, double area, SourceSample& result) const;

  const Problem& problem_;
  const P1Element& element_;
  int region_;
  bool with_corners_;
};

}  // namespace parmesan
