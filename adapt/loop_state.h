#pragma once

#include <optional>
#include <vector>

#include "adapt/interpolation_limit.h"
#include "adapt/iterate.h"
#include "adapt/sizing.h"
#include "adapt/summary.h"

namespace parmesan {

/// What the loop knows after a row: enough to go on from there and to come to the same end, bit by bit.
struct LoopState {
  Iterate last;
  std::optional<Iterate> met;               // the smallest mesh that met all error targets
  bool is_met = false;                      // the last mesh is that one again, for good
  double asked = 0.0;                       // vertices asked for last
  bool unchanged = false;                   // the last mesh is the one before it
  bool limits_bind = false;                 // the size limits forbid the size asked for
  double seconds = 0.0;                     // wall time spent so far
  std::vector<SizeStep> history;            // one per row
  std::optional<InterpolationLimit> limit;  // absent without an exact function
  Summary summary;                          // its rows and warnings so far
};

}  // namespace parmesan
