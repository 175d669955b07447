#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "adapt/metric_options.h"
#include "fem/norms.h"

namespace parmesan {

/// What the loop tries to reach and when it gives up. Absent ones are not looked at.
struct Targets {
  std::optional<double> l2_error, h1_error, linf_error;
  std::optional<double> goal_error;          // of Case::goal
  std::optional<std::int64_t> vertices;      // aim at this size
  std::optional<std::int64_t> max_vertices;  // never ask for more
  int max_iterations = 20;
  std::optional<double> max_seconds;
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

/// Throws LimitError for a number of vertices aimed at that is above the safety limit.
void require_within_limit(const Targets& targets, std::int64_t max_vertices);

/// Whether an L2 error is no more than the round-off of a function with these nodal values: 1e-14 of the norm that the
/// largest would have everywhere.
bool is_round_off(double l2, const Mesh& mesh, std::span<const double> values);

}  // namespace parmesan
