#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// A function known in closed form, to measure errors against.
struct ExactFunction {
  std::function<double(const Point&)> value;
  std::function<Vector(const Point&)> gradient;
};

/// Norms of the difference; h1 is the seminorm ||grad e||.
struct ErrorNorms {
  double l1 = 0.0;
  double l2 = 0.0;
  double linf = 0.0;
  double h1 = 0.0;
  long num_nonfinite = 0;  // quadrature points where the exact function was not finite
  double left_out = 0.0;   // share of the area that they stand for
  double l2_doubt = 0.0;   // share of the square of l2 that quadrature rules do not agree on
};

/// Nodal values of the P1 interpolant.
std::vector<double> interpolate(const Mesh& mesh, const std::function<double(const Point&)>& f);

/// Error of the P1 function with these nodal values, by quadrature that sees layers inside elements.
///
/// Conical Gauss product with 6 x 6 points (degree 10), accepted where the degree 6 rule agrees on
/// the integrals of e^2 and |grad e|^2 within 1e-3 of what a triangle contributes in the mean, else
/// subdivided 1:4, the tolerance halved each time, at most 14 times, as long as a level has at most 40 000 parts and
/// one per triangle more, and until all that the rules disagree on is 1e-3 of the integrals over the mesh. On meshes of
/// more than 20000 triangles the degree 6 rule is enough where the degree 4 rule agrees ten times closer. linf is the
/// largest |e| at the points used, and the one that a search finds in the 256 worst triangles. Quadrature points never
/// lie on vertices or edges; where the exact function is not finite they are left out and counted; all norms are NaN
/// where it is nowhere. h1 is NaN without a gradient. The exact function is called from one thread. Errors: InputError
/// when the sizes differ. Cost: 18 to 54 points per smooth triangle.
ErrorNorms error_norms(const Mesh& mesh, std::span<const double> values, const ExactFunction& exact);

}  // namespace parmesan
