#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "fem/norms.h"
#include "fem/problem.h"
#include "fem/solve.h"
#include "tests/support/meshes.h"

namespace parmesan::support {

/// u = sin(2x + y) + x exp(y) / 4 with its derivatives by hand.
struct Wave {
  static double value(const Point& p) { return std::sin(2 * p.x + p.y) + 0.25 * p.x * std::exp(p.y); }
  static Vector gradient(const Point& p) {
    const double c = std::cos(2 * p.x + p.y), e = 0.25 * std::exp(p.y);
    return {2 * c + e, c + p.x * e};
  }
  static double xx(const Point& p) { return -4 * std::sin(2 * p.x + p.y); }
  static double xy(const Point& p) { return -2 * std::sin(2 * p.x + p.y) + 0.25 * std::exp(p.y); }
  static double yy(const Point& p) { return -std::sin(2 * p.x + p.y) + 0.25 * p.x * std::exp(p.y); }
  static ExactFunction exact() { return {value, gradient}; }
};

inline BoundaryCondition dirichlet(BoundaryData value) { return {BoundaryKind::Dirichlet, std::move(value), {}}; }
inline BoundaryCondition neumann(BoundaryData value) { return {BoundaryKind::Neumann, std::move(value), {}}; }
inline BoundaryCondition robin(BoundaryData coefficient, BoundaryData value) {
  return {BoundaryKind::Robin, std::move(value), std::move(coefficient)};
}

/// The unit square with 4 x 4 cells and an interior constraint of this label along x = 1/2.
inline Mesh square_with_middle_line(int label) {
  Mesh mesh = rectangle_mesh(4, 4);
  for (int j = 0; j < 4; ++j) {
    mesh.edges.push_back({5 * j + 2, 5 * (j + 1) + 2});
    mesh.labels.push_back(label);
  }
  return mesh;
}

/// Dirichlet data of u on the four sides of a rectangle.
inline std::map<int, BoundaryCondition> dirichlet_everywhere(double (*u)(const Point&)) {
  const BoundaryCondition condition = dirichlet([u](const Point& p, const Vector&, int) { return u(p); });
  return {{Bottom, condition}, {Right, condition}, {Top, condition}, {Left, condition}};
}

/// The problem of which that is the solution, with constant coefficients.
inline Problem wave(const Diffusion& k, const Vector& b = {}, double c = 0.0) {
  Problem problem;
  problem.diffusion = [k](const Point&, int) { return k; };
  if (b != Vector{}) problem.velocity = [b](const Point&, int) { return b; };
  problem.reaction = [c](const Point&, int) { return c; };
  problem.source = [=](const Point& p, int) {
    return -(k.xx * Wave::xx(p) + 2 * k.xy * Wave::xy(p) + k.yy * Wave::yy(p)) + dot(b, Wave::gradient(p)) +
           c * Wave::value(p);
  };
  problem.boundary = dirichlet_everywhere(Wave::value);
  return problem;
}

inline BoundaryData constant(double value) {
  return [value](const Point&, const Vector&, int) { return value; };
}

/// 3 - 2x + 5y.
inline double linear(const Point& p) { return 3 - 2 * p.x + 5 * p.y; }

inline double quadratic(const Point& p) {
  return 1 + 2 * p.x - p.y + 1.5 * p.x * p.x - 4 * p.x * p.y + 2.5 * p.y * p.y;
}
inline Vector quadratic_gradient(const Point& p) { return {2 + 3 * p.x - 4 * p.y, -1 - 4 * p.x + 5 * p.y}; }

/// Largest difference at the vertices.
inline double largest_error(const Mesh& mesh, std::span<const double> values, double (*exact)(const Point&)) {
  double largest = 0.0;
  for (std::size_t v = 0; v < values.size(); ++v) {
    largest = std::max(largest, std::abs(values[v] - exact(mesh.points[v])));
  }
  return largest;
}

/// The message of the ProblemError that solving raises.
inline std::string refusal(const Mesh& mesh, const Problem& problem) {
  try {
    solve(mesh, problem);
  } catch (const ProblemError& error) {
    return error.what();
  }
  return "";
}

/// -laplace u = 1 on a rectangle, u = 0 on all sides.
inline Problem unit_poisson() {
  Problem problem;
  problem.diffusion = [](const Point&, int) { return identity_tensor; };
  problem.source = [](const Point&, int) { return 1.0; };
  for (const int label : {Bottom, Right, Top, Left}) problem.boundary[label] = dirichlet({});
  return problem;
}

/// The same condition on all labels.
inline void set_all(Problem& problem, const BoundaryCondition& condition) {
  for (auto& [label, old] : problem.boundary) old = condition;
}

}  // namespace parmesan::support
