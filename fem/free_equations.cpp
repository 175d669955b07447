#include "fem/free_equations.h"

#include <utility>

#include "mesher/index.h"

namespace parmesan {

namespace {

std::vector<char> with_held(std::vector<char> fixed, const NullSpace& null_space) {
  for (const std::vector<int>& component : null_space.components) fixed[at(component.front())] = 1;
  return fixed;
}

MatrixKind kind_of(const AssembledSystem& system) {
  return {
      .symmetric = system.symmetric, .definite = system.symmetric && system.definite, .peclet_max = system.peclet_max};
}

}  // namespace

FreeEquations::FreeEquations(const AssembledSystem& system, std::vector<char> fixed, const NullSpace& null_space,
                             const SolverOptions& options)
    : system_(system),
      null_space_(null_space),
      fixed_(with_held(std::move(fixed), null_space)),
      reduced_(reduced_matrix(system.matrix, fixed_)),
      solver_(reduced_.matrix, kind_of(system), options) {}

VertexValues FreeEquations::solve(const Eigen::VectorXd& load, std::span<const double> given,
                                  std::span<const double> guess) {
  const std::vector<int>& vertices = reduced_.vertices;
  Eigen::VectorXd start = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; !guess.empty() && i < vertices.size(); ++i)
    start[static_cast<Eigen::Index>(i)] = guess[at(vertices[i])];
  VertexValues result{{given.begin(), given.end()},
                      solver_.solve(reduced_load(system_.matrix, load, fixed_, given), start)};
  set(result.linear.x, result.values);
  return result;
}

std::optional<std::vector<double>> FreeEquations::approximate(const Eigen::VectorXd& load) {
  std::vector<double> values(fixed_.size(), 0.0);
  const std::optional<Eigen::VectorXd> x = solver_.approximate(reduced_load(system_.matrix, load, fixed_, values));
  if (!x) return std::nullopt;
  set(*x, values);
  return values;
}

void FreeEquations::set(const Eigen::VectorXd& x, std::vector<double>& values) const {
  for (std::size_t i = 0; i < reduced_.vertices.size(); ++i)
    values[at(reduced_.vertices[i])] = x[static_cast<Eigen::Index>(i)];
  const Eigen::Map<const Eigen::VectorXd> u(values.data(), system_.mass.size());
  remove_means(null_space_, system_, system_.mass.cwiseProduct(u), values);
}

}  // namespace parmesan
