#pragma once

#include <functional>

#include "mesher/mesh.h"

namespace parmesan::oracle {

using ScalarFunction = std::function<double(const Point&)>;

/// Squared L2 norm of u - I u over the triangle abc, I u the linear function that equals u at the corners:
/// values of u at the 4 x 4 points of Gauss's product rule on the square collapsed to the triangle, exact for
/// quadratics u.
double squared_interpolation_error(const Point& a, const Point& b, const Point& c, const ScalarFunction& u);

/// The same over all triangles of a mesh.
double squared_interpolation_error(const Mesh& mesh, const ScalarFunction& u);

}  // namespace parmesan::oracle
