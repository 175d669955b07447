#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fem/free_equations.h"
#include "fem/quadratic.h"
#include "fem/refined_patch.h"
#include "fem/smooth_parts.h"

namespace parmesan {

/// Better values than those of a P1 function w around singular vertices, and what they mean to the rest of the mesh.
struct LocalCorrection {
  std::vector<double> change;    // v - w at the vertices of the patch
  std::vector<Surplus> surplus;  // of v on the triangles of the patch, above its values at their corners
  Eigen::VectorXd load;          // B(w, phi_i) - B(v, phi_i) on the patch, for the vertices of the patch
};

/// Solutions on refined patches around the singular vertices of a mesh (local defect correction: Hackbusch, Numer.
/// Math. 43 (1984) 379), where recovered gradients say little of the solution.
class LocalSolution {
 public:
  /// Empty where nothing is singular, or refined_patch() or the equations on the patch are of no use. The whole mesh of
  /// the parts must live as long. Cost: O(n), and the factorization of the equations of twelve vertices for each
  /// triangle of the patch.
  LocalSolution(const SmoothParts& parts, const Problem& problem, const std::vector<Side>& sides);
  LocalSolution(const LocalSolution&) = delete;
  LocalSolution& operator=(const LocalSolution&) = delete;

  bool empty() const { return !equations_; }
  const std::vector<int>& triangles() const { return patch_.triangles; }
  const std::vector<int>& vertices() const { return patch_.vertices; }

  /// The P1 solution v on the refined patch that is, where the patch ends, w and the quadratics with this surplus.
  /// values: n, of w; surplus: of all triangles of the mesh. Nothing where it is not found.
  std::optional<LocalCorrection> correct(std::span<const double> values, std::span<const Surplus> surplus);

 private:
  void prepare(const Problem& problem);
  std::vector<double> given_values(std::span<const double> values, std::span<const Surplus> surplus) const;
  std::vector<Surplus> surplus_of(std::span<const double> fine) const;

  const Mesh& mesh_;
  RefinedPatch patch_;
  AssembledSystem coarse_, fine_;
  FixedVertices dirichlet_;  // of fine
  NullSpace nothing_;
  std::optional<FreeEquations> equations_;
};

}  // namespace parmesan
