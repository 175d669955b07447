#pragma once

#include <array>
#include <span>
#include <vector>

#include "fem/coefficients.h"
#include "fem/p1.h"

namespace parmesan {

/// By how much the function with these gradients at the ends of an edge exceeds, in the middle of the edge, the mean of
/// its values there; for cubics exactly.
constexpr double surplus(const Vector& from, const Vector& to, const Vector& edge) {
  return dot(from - to, edge) / 8.0;
}

/// The surplus of a function on the edges opposite to the corners of a triangle.
using Surplus = std::array<double, 3>;

/// Of each triangle, for the function with these values and gradients at the vertices. Each end of an edge gives a
/// surplus of its own, (g.e - rise) / 4 at the first and (rise - g.e) / 4 at the last; theirs is the mean, but at most
/// three times the smaller one: long edges that end in a layer have no surplus of the layer's size. Cost: O(n).
std::vector<Surplus> surpluses(const Mesh& mesh, std::span<const double> values, std::span<const Vector> gradients);

/// A quadratic on a triangle that vanishes at its corners, what the P2 interpolant has above the P1 one:
///
///     q = 4 (s_0 l_1 l_2 + s_1 l_2 l_0 + s_2 l_0 l_1).
struct Quadratic {
  Surplus surplus{};

  double at(const Barycentric& l) const {
    return 4.0 * (surplus[0] * l[1] * l[2] + surplus[1] * l[2] * l[0] + surplus[2] * l[0] * l[1]);
  }

  Vector gradient(const P1Element& element, const Barycentric& l) const;
};

/// div(K grad w), w the quadratic and a linear function with this gradient: the divergence of the linear function that
/// K grad w is at three points inside.
template <class DiffusionAt>
double diffused(const P1Element& element, const Vector& linear, const Quadratic& quadratic, const DiffusionAt& k) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    Barycentric l{1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0};
    l[i] = 2.0 / 3.0;  // where the function 2 l_i - 1/3 is 1, and 0 at the others
    sum += 2.0 * dot(element.gradient[i], k(element.at(l)) * (linear + quadratic.gradient(element, l)));
  }
  return sum;
}

}  // namespace parmesan
