#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// Norms of an error; h1 is the seminorm.
struct EstimatedError {
  double l2 = 0.0;
  double h1 = 0.0;
  double linf = 0.0;
};

/// By how much the function with these gradients at the ends of an edge exceeds, in the middle of the edge, the mean of
/// its values there; for cubics exactly.
constexpr double surplus(const Vector& from, const Vector& to, const Vector& edge) {
  return dot(from - to, edge) / 8.0;
}

/// The surplus of a function on the edges opposite to the corners of a triangle: its P2 interpolant is the P1 one plus
///
///     4 (s_0 l_1 l_2 + s_1 l_2 l_0 + s_2 l_0 l_1).
using Surplus = std::array<double, 3>;

/// Of each triangle, for the function with these gradients at the vertices. Cost: O(n).
std::vector<Surplus> surpluses(const Mesh& mesh, std::span<const Vector> gradients);

/// L2 norm and maximum of the error that has this surplus, and these values at the vertices (zero where empty).
EstimatedError error_of(const Mesh& mesh, std::span<const Surplus> surplus, std::span<const double> nodal = {});

/// H1 seminorm of the difference between recovered gradients and those of the P1 function with these values, which
/// estimates its error (Zienkiewicz & Zhu, Int. J. Numer. Meth. Engng 33 (1992) 1331).
double gradient_error(const Mesh& mesh, std::span<const double> values, std::span<const Vector> gradients);

}  // namespace parmesan
