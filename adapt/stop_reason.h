#pragma once

#include <string_view>

namespace parmesan {

/// Why a run ended.
enum class StopReason {
  ErrorTarget,    // all declared error targets met
  GoalTarget,     // the same, the error of a functional among them
  Vertices,       // the size aimed at was reached and nothing else was declared
  VertexBudget,   // a larger mesh would exceed max_vertices
  TimeBudget,     // max_seconds are over
  MaxIterations,  // max_iterations rows were made
  Unchanged,      // the mesh no longer changes
  Floor,          // the error is round-off
  Stagnated,      // more vertices no longer reduce the error, or size limits forbid more
  Interrupted     // the user asked to stop
};

/// The name used in summary.json, e.g. "error_target".
std::string_view to_string(StopReason reason);

}  // namespace parmesan
