#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>

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
  const LoopState* resume = nullptr;                    // goes on there
  bool isotropic = false;                               // metrics of the form s I
  std::optional<ErrorMeasure> measure = {};             // what metrics make small; absent: error_measure(targets)
  const Iterate* start = nullptr;                       // begins there, with values
  std::optional<InterpolationLimit> limit = {};         // computed on the first mesh when absent and needed
};

/// The rows and the last state.
struct LoopResult {
  Summary summary;
  Iterate last;
  std::optional<InterpolationLimit> limit;  // absent without an exact function
};

/// How far the errors are from the case's targets: the largest of error / target, squared for H1 so
/// that it falls like 1 / vertices. Without error targets the L2 error itself. NaN counts as missed.
/// goal: the size of the goal's error.
double target_excess(const Targets& targets, const ErrorNorms& error,
                     double goal = std::numeric_limits<double>::quiet_NaN());

/// Does the case declare an error target, of a norm or of a goal?
bool declares_error_target(const Targets& targets);

/// Does it declare one of a norm?
bool declares_norm_target(const Targets& targets);

/// The error that metrics are to make small: H1 where the case's only error target is an H1 error.
ErrorMeasure error_measure(const Targets& targets);

/// Whether an L2 error is no more than the round-off of a function with these nodal values: 1e-14 of the largest.
bool is_round_off(double l2, std::span<const double> values);

/// Mesh, solve, measure, recover, metric, remesh from the previous particles, until the targets are
/// met or a budget is spent (see StopReason and next_size). The first mesh is uniform, or that of
/// continuation, unless options.start is given. From a state that an observer was given, with options.resume, the loop
/// comes to the end it would have come to without a break, bit by bit.
///
/// Errors: as generate and solve; LimitError when targets.vertices exceeds the safety limit.
LoopResult adapt(const Case& input, const LoopOptions& options);

}  // namespace parmesan
