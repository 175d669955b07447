#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "adapt/case.h"
#include "adapt/iterate.h"
#include "adapt/loop_state.h"
#include "adapt/summary.h"

namespace parmesan {

/// What the loop is given beside the case.
struct LoopOptions {
  int threads = 1;                                      // only reported
  std::int64_t max_vertices = 10'000'000;               // safety limit, LimitError beyond
  const std::atomic<bool>* interrupted = nullptr;       // looked at between stages
  std::function<void(const LoopState&)> observer = {};  // after every row
  bool isotropic = false;                               // metrics of the form s I
  const Targets* aims = nullptr;                        // whose errors metrics make small; absent: those of the case
};

/// Where the loop begins.
struct LoopStart {
  const LoopState* resume = nullptr;             // goes on there
  bool is_other_case = false;                    // whose state `resume` is: its mesh is solved on, and judged, anew
  const Iterate* first = nullptr;                // begins there, with values; absent: uniform, or that of continuation
  std::optional<InterpolationLimit> limit = {};  // computed on the first mesh when absent and needed
};

/// The rows and the last state.
struct LoopResult {
  Summary summary;
  Iterate last;
  std::optional<InterpolationLimit> limit;  // absent without an exact function
};

/// Mesh, solve, measure, recover, metric, remesh from the previous particles, until the targets are
/// met or a budget is spent (see StopReason and next_size). From a state that an observer was
/// given, with start.resume, the loop comes to the end it would have come to without a break, bit by bit.
///
/// Errors: as generate and solve; LimitError when targets.vertices exceeds the safety limit.
LoopResult adapt(const Case& input, const LoopOptions& options, const LoopStart& start = {});

}  // namespace parmesan
