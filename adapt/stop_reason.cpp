#include "adapt/stop_reason.h"

namespace parmesan {

std::string_view to_string(StopReason reason) {
  switch (reason) {
    case StopReason::ErrorTarget:
      return "error_target";
    case StopReason::GoalTarget:
      return "goal_target";
    case StopReason::Vertices:
      return "vertices";
    case StopReason::VertexBudget:
      return "vertex_budget";
    case StopReason::TimeBudget:
      return "time_budget";
    case StopReason::MaxIterations:
      return "max_iterations";
    case StopReason::Unchanged:
      return "unchanged";
    case StopReason::Floor:
      return "floor";
    case StopReason::Stagnated:
      return "stagnated";
    case StopReason::Interrupted:
      return "interrupted";
  }
  return "";
}

}  // namespace parmesan
