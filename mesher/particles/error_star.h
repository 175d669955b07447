#pragma once

#include <span>
#include <vector>

#include "mesher/particles/particle_system.h"
#include "mesher/particles/star.h"
#include "mesher/particles/triangle_error.h"

namespace parmesan {

/// The triangles around one particle with the Hessians at their vertices: the squared L2 error of linear
/// interpolation over the star, each triangle in the mean Hessian of its vertices (squared_error).
class ErrorStar {
 public:
  /// hessians: one per vertex slot.
  void gather(const ParticleSystem& particles, std::span<const SymmetricTensor> hessians, VertexId v);

  const Star& star() const { return star_; }

  /// The squared error if the particle were at p, with the Hessian h there.
  double squared_error(const Point& p, const SymmetricTensor& h) const;

  /// The same with its gradient, in which h changes with p as fitted to the neighbours, and with the second
  /// derivatives for h held.
  ErrorJet jet(const Point& p, const SymmetricTensor& h) const;

 private:
  struct Slope {
    SymmetricTensor x, y;  // derivatives of the Hessian
  };
  Slope fitted_slope(const Point& p, const SymmetricTensor& h) const;

  /// Calls f(b, c, mean Hessian) for each triangle pbc.
  template <class F>
  void for_each_triangle(const SymmetricTensor& h, F f) const;

  Star star_;
  std::vector<SymmetricTensor> around_;  // Hessian at the end of each spoke
};

}  // namespace parmesan
