#include "fem/null_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/adjacency.h"
#include "fem/coefficients.h"
#include "fem/linear_solver.h"
#include "fem/reduction.h"
#include "mesher/index.h"
#include "mesher/number_text.h"

namespace parmesan {

namespace {

constexpr double max_mismatch = 5e-3;

/// Everything fixed at 0 but the vertices of the components.
FixedVertices all_but(const NullSpace& null_space, std::size_t num_vertices) {
  FixedVertices fixed{std::vector<char>(num_vertices, 1), std::vector<double>(num_vertices, 0.0)};
  for (const std::vector<int>& component : null_space.components) {
    for (const int v : component) fixed.fixed[at(v)] = 0;
  }
  return fixed;
}

/// A nonsymmetric system with these vertices fixed; the first guess is a constant.
Eigen::VectorXd solve_nonsymmetric(const AssembledSystem& system, const FixedVertices& fixed, double peclet_max,
                                   double guess) {
  const ReducedMatrix reduced = reduced_matrix(system.matrix, fixed.fixed);
  const Eigen::VectorXd load = reduced_load(system.matrix, system.load, fixed.fixed, fixed.values);
  const Eigen::VectorXd start = Eigen::VectorXd::Constant(load.size(), guess);
  const Eigen::VectorXd x = LinearSolver(reduced.matrix, {.peclet_max = peclet_max}).solve(load, start).x;
  Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(fixed.values.data(), system.load.size());
  for (std::size_t i = 0; i < reduced.vertices.size(); ++i)
    values[reduced.vertices[i]] = x[static_cast<Eigen::Index>(i)];
  return values;
}

/// The left null vector of each component up to a factor, by a step of inverse iteration from the masses.
Eigen::VectorXd inverse_iterate(const NullSpace& null_space, const AssembledSystem& system) {
  constexpr double relative_shift = 1e-7;  // far below the other eigenvalues; 1e-14 would pass for a singular matrix
  const double shift = relative_shift * system.matrix.diagonal().sum() / system.mass.sum();
  AssembledSystem shifted;
  shifted.matrix = system.matrix.transpose();
  shifted.matrix += RowMatrix((shift * system.mass).asDiagonal());
  shifted.load = system.mass;
  const FixedVertices fixed = all_but(null_space, static_cast<std::size_t>(system.load.size()));
  return solve_nonsymmetric(shifted, fixed, system.peclet_max, 0.0);
}

/// Puts the vertex first where the left null vector is largest: where it is small, with velocities nearly everywhere,
/// the equation that is left out there does not follow from the others.
void hold_where_felt(const AssembledSystem& system, NullSpace& null_space) {
  if (system.symmetric) return;
  const Eigen::VectorXd w = inverse_iterate(null_space, system);
  for (std::vector<int>& component : null_space.components) {
    const auto most = std::ranges::max_element(component, {}, [&w](int v) { return std::abs(w[v]); });
    std::iter_swap(component.begin(), most);
  }
}

/// 1 on the components.
Eigen::VectorXd constants(const NullSpace& null_space, Eigen::Index num_vertices) {
  Eigen::VectorXd ones = Eigen::VectorXd::Zero(num_vertices);
  for (const std::vector<int>& component : null_space.components) {
    for (const int v : component) ones[v] = 1.0;
  }
  return ones;
}

/// w with w^T A = 0 and w = 1 at the first vertex of each component; 0 off the components.
Eigen::VectorXd left_null_vector(const NullSpace& null_space, const AssembledSystem& system) {
  if (system.symmetric) return null_space.right;
  FixedVertices fixed = all_but(null_space, static_cast<std::size_t>(system.load.size()));
  for (const std::vector<int>& component : null_space.components) {
    fixed.fixed[at(component.front())] = 1;
    fixed.values[at(component.front())] = 1.0;
  }
  AssembledSystem transposed;
  transposed.matrix = system.matrix.transpose();
  transposed.load.setZero(system.load.size());
  return solve_nonsymmetric(transposed, fixed, system.peclet_max, 1.0);
}

[[noreturn]] void refuse(const Mesh& mesh, const std::vector<int>& component, double mismatch, double magnitude) {
  throw ProblemError(
      "the solution is determined only up to a constant on the part of the mesh that holds the point " +
      text(mesh.points[at(component.front())]) +
      " (no Dirichlet or Robin condition, no reaction), and the data do not balance there: the integrals of the source "
      "and of the boundary fluxes add up to " +
      text(mismatch, 6) + ", they must add up to 0 (their absolute values add up to " + text(magnitude, 6) + ")");
}

}  // namespace

NullSpace find_null_space(const Mesh& mesh, const AssembledSystem& system, const FixedVertices& dirichlet) {
  const std::vector<int> component = vertex_components(mesh);
  if (component.empty()) return {};
  const auto count = static_cast<std::size_t>(*std::max_element(component.begin(), component.end())) + 1;
  std::vector<char> anchored(count, 0);
  std::vector<std::vector<int>> vertices(count);
  for (std::size_t v = 0; v < component.size(); ++v) {
    const auto c = static_cast<std::size_t>(component[v]);
    if (dirichlet.fixed[v] || system.anchored[v]) anchored[c] = 1;
  }
  for (std::size_t v = 0; v < component.size(); ++v) {
    const auto c = static_cast<std::size_t>(component[v]);
    if (!anchored[c]) vertices[c].push_back(static_cast<int>(v));
  }
  std::erase_if(vertices, [](const std::vector<int>& list) { return list.empty(); });
  NullSpace null_space{.components = std::move(vertices), .left = {}, .right = {}};
  if (null_space.components.empty()) return null_space;
  hold_where_felt(system, null_space);
  null_space.right = constants(null_space, system.load.size());
  null_space.left = left_null_vector(null_space, system);
  return null_space;
}

NullSpace transposed(NullSpace null_space) {
  std::swap(null_space.left, null_space.right);
  return null_space;
}

double balance_load(const Mesh& mesh, const NullSpace& null_space, AssembledSystem& system) {
  const Eigen::VectorXd& w = null_space.left;
  double worst = 0.0;
  for (const std::vector<int>& component : null_space.components) {
    double mismatch = 0.0;
    double magnitude = 0.0;
    for (const int v : component) {
      mismatch += w[v] * system.load[v];
      magnitude += std::abs(w[v] * system.load[v]);
    }
    if (std::abs(mismatch) > max_mismatch * magnitude) refuse(mesh, component, mismatch, magnitude);
    if (magnitude > 0.0) worst = std::max(worst, std::abs(mismatch) / magnitude);
  }
  remove_imbalance(null_space, system, system.load);
  return worst;
}

void remove_imbalance(const NullSpace& null_space, const AssembledSystem& system, Eigen::VectorXd& load) {
  const Eigen::VectorXd& w = null_space.left;
  for (const std::vector<int>& component : null_space.components) {
    double mismatch = 0.0;
    double mass = 0.0;
    for (const int v : component) {
      mismatch += w[v] * load[v];
      mass += w[v] * system.mass[v];
    }
    for (const int v : component) load[v] -= mismatch / mass * system.mass[v];
  }
}

void remove_means(const NullSpace& null_space, const AssembledSystem& system, const Eigen::VectorXd& integrals,
                  std::vector<double>& values) {
  for (const std::vector<int>& component : null_space.components) {
    double integral = 0.0;
    double mass = 0.0;
    for (const int v : component) {
      integral += integrals[v];
      mass += system.mass[v] * null_space.right[v];
    }
    for (const int v : component) values[at(v)] -= integral / mass * null_space.right[v];
  }
}

}  // namespace parmesan
