#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "adapt/stop_reason.h"

namespace parmesan {

/// What one pass of the loop gave, as far as the choice of the next size is concerned.
struct SizeStep {
  double asked = 0.0;     // vertices asked of the mesher
  double vertices = 0.0;  // vertices it gave
  double error = 0.0;     // falls like 1 / vertices: an L2 error, or the square of an H1 error. With
                          // error targets: the largest error / target, so 1 means all are met.
                          // Infinite where it is not known
  bool adapted = true;    // false for the uniform mesh at the start
};

/// Where the sizes are to lead.
struct SizeGoal {
  bool error_targets = false;      // until SizeStep::error <= 1
  std::optional<double> vertices;  // until this size
  std::optional<double> cap;       // never ask for more
  int max_passes = 0;              // in all; 0: not known
  bool may_shrink = true;          // smaller sizes may be tried once error targets are met
};

/// The size to ask for next, or why there is none.
struct SizeDecision {
  double asked = 0.0;
  std::optional<StopReason> stop;
};

/// Whether a mesh of so many vertices has the size aimed at: to 3 %.
inline bool has_size(double vertices, double aimed) { return std::abs(vertices - aimed) <= 0.03 * aimed; }

/// Vertices at which an error that falls like vertices^-order reaches the target.
double predicted_vertices(double vertices, double error, double target, double order);

/// The order with which SizeStep::error fell between the last passes at the last two sizes, averaged with theory's
/// order 1 as if that had been seen over a factor of 4 (errors scatter by 10 %), limited to [0.4, 1.1]; 1 when there is
/// only one size.
double observed_order(std::span<const SizeStep> history);

/// A ladder of sizes, several passes on each so that mesh and solution settle:
/// - the first size is repeated while a pass still reduces the error by more than 1.5, at least 3 times;
/// - a further size is repeated while error * vertices falls by more than 1.5, and once if it rose by
///   more than 1.25 against the size before;
/// - the last size (the one aimed at, or the cap) until a pass gains less than 5 %, at least 3 passes, and the one
///   aimed at until the mesh has that size (has_size);
/// - no size more than 8 times, and none grows by more than 4 times, by 2 where the error fell faster
///   than order 1.5 or the last pass at the size before gained more than 1.2: there meshes only begin to
///   resolve the solution, and fewer vertices may do;
/// - towards error targets the next size is predicted with the observed order and 2 % on top, doubled
///   up to 16 % after each pass that missed by little: meshes follow small changes of size with delay.
///   Of a prediction beyond 1.5 times the last size only 3/4 is asked for, and at least 1.5 times the last size: a mesh
///   that has not yet found all of a layer improves faster than the observed order says;
/// - a mesh that meets the targets with 5 % more vertices than they are predicted to need is made smaller, to 3/4 of
///   the prediction where the error fell faster than order 1.5, at most twice and as long as 3 of max_passes are left
///   to come back if the prediction was wrong, but never below half of its vertices or the first size;
/// - towards a size aimed at, none of this holds it back from growing when max_passes would end the loop before it has
///   had 3 passes at that size.
///
/// Stops with ErrorTarget, Vertices, VertexBudget, Stagnated (with error targets: 4 passes, after 3 others at least, in
/// which the error did not fall by 2 %; with a size aimed at: 8 passes that missed it), or Unchanged when nothing is
/// aimed at and the first size has settled.
SizeDecision next_size(std::span<const SizeStep> history, const SizeGoal& goal);

}  // namespace parmesan
