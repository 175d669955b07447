#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fem/functionals.h"
#include "fem/problem.h"
#include "fem/sides.h"
#include "mesher/cracks.h"

namespace parmesan {

/// Whether the gradient jumps across a side: between regions whose diffusion differs by more than 1 %, and at interior
/// constraints with given values.
bool gradient_jumps(const Mesh& mesh, const Problem& problem, const Side& side);

/// The mesh taken apart where the gradient of the solution jumps: along sides between regions with different diffusion,
/// and along interior constraints with given values. Vertices there are doubled, so that gradients and second
/// derivatives that are recovered on the parts know nothing of the other side. Triangles keep their order.
///
/// The gradient of a dual solution jumps along interior constraints that its goal weighs u on, too.
class SmoothParts {
 public:
  /// sides: labelled_sides(mesh); dual_of: of its dual solution for this goal. The mesh must live as long. Errors: what
  /// the diffusion throws. Cost: O(n) where something jumps, else O(sides).
  SmoothParts(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
              const GoalFunctional* dual_of = nullptr);

  /// The mesh itself where nothing jumps.
  const Mesh& mesh() const { return opened_ ? opened_->mesh : *whole_; }
  const Mesh& whole() const { return *whole_; }

  /// Which vertex of the whole mesh each one is.
  int source(std::size_t vertex) const { return opened_ ? opened_->sources[vertex] : static_cast<int>(vertex); }

  /// What a vertex of the whole mesh has, at each of its copies.
  std::vector<double> spread(std::span<const double> values) const;

 private:
  const Mesh* whole_;
  std::optional<OpenedMesh> opened_;
};

}  // namespace parmesan
