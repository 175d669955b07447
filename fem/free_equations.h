#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fem/linear_solver.h"
#include "fem/null_space.h"
#include "fem/reduction.h"

namespace parmesan {

/// Values at all vertices, and how they were found.
struct VertexValues {
  std::vector<double> values;
  LinearResult linear;
};

/// The equations of the vertices whose values are free, ready to be solved for several loads.
class FreeEquations {
 public:
  /// The system and the null space must live as long. fixed: n flags; the vertex that each component of the null space
  /// is held at is fixed too.
  FreeEquations(const AssembledSystem& system, std::vector<char> fixed, const NullSpace& null_space,
                const SolverOptions& options = {});
  FreeEquations(const FreeEquations&) = delete;
  FreeEquations& operator=(const FreeEquations&) = delete;

  /// How many values are free.
  std::size_t num_unknowns() const { return reduced_.vertices.size(); }

  /// A x = load where x is free, x = given elsewhere (n values), means zero on the components of the null space: of
  /// the solutions there, which differ by multiples of the right null vector.
  /// guess: n values to iterate from, or none. Errors: as LinearSolver.
  VertexValues solve(const Eigen::VectorXd& load, std::span<const double> given, std::span<const double> guess = {});

  /// The same with zeros in place of given values, as well and as fast as LinearSolver::approximate: n values, or
  /// nothing.
  std::optional<std::vector<double>> approximate(const Eigen::VectorXd& load);

 private:
  /// The unknowns among these values at all vertices become x.
  void set(const Eigen::VectorXd& x, std::vector<double>& values) const;

  const AssembledSystem& system_;
  const NullSpace& null_space_;
  std::vector<char> fixed_;
  ReducedMatrix reduced_;
  LinearSolver solver_;
};

}  // namespace parmesan
