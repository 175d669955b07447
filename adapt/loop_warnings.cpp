#include "adapt/loop_warnings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "adapt/diffusion_jumps.h"
#include "adapt/measure.h"
#include "adapt/number_text.h"
#include "adapt/sizing.h"
#include "fem/boundary_conditions.h"
#include "fem/point_sources.h"
#include "mesher/index.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

// "h_max at 12 vertices in [0, 1] x [0.5, 1]"
std::string limit_text(const char* name, const Clipped& clipped) {
  const auto range = [](double low, double high) {
    return "[" + short_number(low, 4) + ", " + short_number(high, 4) + "]";
  };
  return std::string(name) + " at " + std::to_string(clipped.count) + " vertices in " +
         range(clipped.low.x, clipped.high.x) + " x " + range(clipped.low.y, clipped.high.y);
}

struct NamedLimit {
  const char* name;
  Clipped clipped;
};

// The limits that can have made a mesh too small.
std::vector<NamedLimit> limits_from_below(const ClippedSizes& clipped) { return {{"h_min", clipped.h_min}}; }

// Those that can have made it too large.
std::vector<NamedLimit> limits_from_above(const ClippedSizes& clipped) {
  return {{"h_max", clipped.h_max}, {"max_aspect", clipped.aspect}, {"gradation", clipped.gradation}};
}

std::string limits_text(const std::vector<NamedLimit>& limits) {
  std::string text;
  for (const auto& [name, clipped] : limits)
    if (clipped.count > 0) text += (text.empty() ? "" : ", ") + limit_text(name, clipped);
  return text;
}

// Whether one of the limits acts at more than half of the vertices.
bool act_at_half(const std::vector<NamedLimit>& limits, std::int64_t vertices) {
  return std::ranges::any_of(limits, [vertices](const NamedLimit& l) { return 2 * l.clipped.count > vertices; });
}

// A loop that ended before it had come to the size that it could have. Empty: none.
std::string_view cut_short_by(StopReason reason) {
  switch (reason) {
    case StopReason::MaxIterations:
      return "its iterations";
    case StopReason::TimeBudget:
      return "its time";
    case StopReason::Interrupted:
      return "an interrupt";
    default:
      return {};
  }
}

std::optional<std::string> of_size(const IterationRow& last, std::optional<std::int64_t> aimed, StopReason reason) {
  const auto got = static_cast<double>(last.vertices);
  if (!aimed) return std::nullopt;
  const auto wanted = static_cast<double>(*aimed);
  if (has_size(got, wanted)) return std::nullopt;
  std::string sentence =
      "the mesh has " + std::to_string(last.vertices) + " vertices, not the " + std::to_string(*aimed) + " aimed at";
  const auto acting = got < wanted ? limits_from_below(last.clipped) : limits_from_above(last.clipped);
  const std::string limits = limits_text(acting);
  const std::string_view end = act_at_half(acting, last.vertices) ? std::string_view{} : cut_short_by(reason);
  if (!end.empty())
    sentence += "; the loop was ended by " + std::string(end);
  else if (!limits.empty())
    sentence += "; limits forbid it: " + limits;
  return sentence;
}

// Of errors that cannot fall further.
std::optional<std::string> of_smallest_size(const IterationRow& last, bool limits_bind, StopReason reason) {
  const auto acting = limits_from_below(last.clipped);
  const std::string limits = limits_text(acting);
  const bool keeps_away = limits_bind || (reason == StopReason::Stagnated && act_at_half(acting, last.vertices));
  if (!keeps_away || limits.empty()) return std::nullopt;
  return "limits forbid smaller triangles: " + limits;
}

// Of an exact function that is infinite somewhere inside: its errors are those of the rest.
std::optional<std::string> of_nonfinite(const IterationRow& last) {
  const std::optional<ErrorNorms>& error = last.solution_error ? last.solution_error : last.interpolation_error;
  if (!error || error->num_nonfinite == 0) return std::nullopt;
  return "the exact function or its gradient is not finite at " + std::to_string(error->num_nonfinite) +
         " quadrature points of the last mesh; the errors leave them out, " + short_number(100.0 * error->left_out, 3) +
         " % of the area";
}

// Of an exact function whose square has no integral, as of 1 / x, or one that quadrature does not come to. Functions
// with layers and kinks: 0.001 at most.
std::optional<std::string> of_uncertain(const IterationRow& last) {
  constexpr double much = 0.01;
  double doubt = 0.0;
  for (const std::optional<ErrorNorms>& error : {last.solution_error, last.interpolation_error})
    if (error) doubt = std::max(doubt, error->l2_doubt);
  if (!(doubt > much)) return std::nullopt;
  return "the L2 error cannot be told: quadrature rules disagree on " + short_number(100.0 * std::min(doubt, 1.0), 3) +
         " % of its square; the square of the exact function may have no integral";
}

// Where errors are but estimated: residuals far above the recovered gradient's estimate. On meshes that resolve the
// data they are 0.7 to 1 of it up to Peclet numbers of 3500; far beyond they grow however well a mesh resolves them.
std::optional<std::string> of_unresolved(const IterationRow& last) {
  constexpr double far_above = 1.5;
  constexpr double largest_peclet = 5e3;
  const bool is_far_above = last.residual_h1 && *last.residual_h1 > far_above * last.estimated_error->h1;
  const bool says_nothing = last.solve_report && last.solve_report->peclet_max > largest_peclet;
  if (last.solution_error || !is_far_above || says_nothing) return std::nullopt;
  return "the last mesh may not resolve the data: its residuals tell of an H1 error of " +
         short_number(*last.residual_h1, 3) + ", the recovered gradient of " +
         short_number(last.estimated_error->h1, 3);
}

// Where the error is known, and the equations tell of a much smaller one.
std::optional<std::string> of_contradiction(const IterationRow& last) {
  constexpr double far_below = 0.1;
  if (!last.solution_error || !last.estimated_error) return std::nullopt;
  const double error = last.solution_error->l2, estimate = last.estimated_error->l2;
  if (!(estimate < far_below * error)) return std::nullopt;
  return "the L2 error is " + short_number(error, 3) + ", its estimate " + short_number(estimate, 3) +
         ": the source, the boundary data or the coefficients may belong to another solution than 'exact'";
}

// Of a correction that was asked for.
std::optional<std::string> of_correction(const IterationRow& last) {
  if (!last.solve_report || last.solve_report->correction_converges) return std::nullopt;
  return "the values are Galerkin's: defect correction does not converge on the last mesh, its last step of " +
         std::to_string(last.solve_report->correction_steps) + " changed it by a factor of " +
         short_number(last.solve_report->correction_change, 2);
}

// Of captured discontinuities whose fixed-point steps did not end.
std::optional<std::string> of_capturing(const IterationRow& last) {
  if (!last.solve_report || last.solve_report->capturing_converges()) return std::nullopt;
  return "discontinuity capturing does not converge on the last mesh: its last step of " +
         std::to_string(last.solve_report->capturing_steps) + " changed the solution by " +
         short_number(last.solve_report->capturing_change, 2) + " of its range, not by less than " +
         short_number(capturing_tolerance, 2);
}

// Of values that were all given.
std::optional<std::string> of_no_unknowns(const IterationRow& last) {
  if (!last.solve_report || last.solve_report->unknowns > 0) return std::nullopt;
  return "no vertex of the last mesh is free: the solution is made of given values alone, and its error is not known";
}

// Of a solution that is 0 though the source is not, which the mesh may miss altogether.
std::optional<std::string> of_unseen_source(const Problem& problem, const IterationRow& last) {
  const bool is_zero = last.solve_report && last.solve_report->minimum == 0.0 && last.solve_report->maximum == 0.0;
  if (!problem.source || !is_zero || last.solution_error) return std::nullopt;
  return "the solution is 0 at all vertices, though 'source' is not the constant 0: where that lies between the points "
         "that a mesh of " +
         std::to_string(last.vertices) + " vertices looks at, a larger \"vertices\" of 'initial' finds it";
}

// Of point sources where u is given, so that they change nothing.
std::vector<std::string> of_idle_point_sources(const Problem& problem, const Mesh& mesh) {
  constexpr double rounding = 1e-9;
  if (problem.point_sources.empty()) return {};
  const FixedVertices fixed = dirichlet_values(mesh, problem, labelled_sides(mesh));
  const std::vector<std::vector<TrianglePlace>> places = places_of_sources(mesh, problem);
  std::vector<std::string> warnings;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto acts = [&](const TrianglePlace& place) {
      for (std::size_t i = 0; i < 3; ++i)
        if (place.lambda[i] > rounding && !fixed.fixed[at(mesh.triangles[at(place.triangle)][i])]) return true;
      return false;
    };
    if (std::ranges::none_of(places[k], acts))
      warnings.push_back("the point source at " + text(problem.point_sources[k].place) +
                         " is where the solution is given: it changes nothing");
  }
  return warnings;
}

// Of a solution that is one of many.
std::optional<std::string> of_constants(const IterationRow& last) {
  const int parts = last.solve_report ? last.solve_report->null_components : 0;
  if (parts == 0) return std::nullopt;
  return "the data leave a constant free" + (parts > 1 ? " on each of " + std::to_string(parts) + " parts" : "") +
         ": the mean of the solution is " + (last.solution_error ? "that of the exact function" : "set to 0");
}

}  // namespace

std::vector<std::string> warnings_of_last(const IterationRow& last, std::optional<std::int64_t> aimed, bool limits_bind,
                                          StopReason reason) {
  std::vector<std::string> warnings;
  const auto add = [&warnings](std::optional<std::string> warning) {
    if (warning) warnings.push_back(std::move(*warning));
  };
  add(of_size(last, aimed, reason));
  if (!aimed) add(of_smallest_size(last, limits_bind, reason));
  if (!satisfies_metric(last.diagnosis)) {
    for (std::string& sentence : sentences(last.diagnosis)) warnings.push_back(std::move(sentence));
  }
  add(of_no_unknowns(last));
  add(of_constants(last));
  add(of_nonfinite(last));
  add(of_unresolved(last));
  const std::optional<std::string> uncertain = of_uncertain(last);
  add(uncertain);
  if (!uncertain) add(of_contradiction(last));
  add(of_correction(last));
  add(of_capturing(last));
  return warnings;
}

std::optional<std::string> hint_of_correction(const Targets& targets, const ErrorNorms& error,
                                              const IterationRow& last) {
  constexpr double much = 2.0;
  const bool may_correct = last.solve_report && last.solve_report->unknowns > 0 && !last.goal &&
                           last.solve_report->correction_steps == 0 && last.solve_report->capturing_steps == 0;
  if (!may_correct || !(targets.l2_error || targets.linf_error)) return std::nullopt;
  const double interpolation = last.interpolation_error ? last.interpolation_error->l2
                               : last.estimated_error   ? last.estimated_error->interpolation_l2
                                                        : std::numeric_limits<double>::quiet_NaN();
  if (!(error.l2 > much * interpolation)) return std::nullopt;
  return "the L2 error is " + short_number(error.l2 / interpolation, 3) +
         " times what exact values at the vertices would leave: \"defect_correction\": true in \"problem\" brings the "
         "solution near to that, and smaller meshes to the target";
}

std::vector<std::string> warnings_of_solution(const Case& input, const Iterate& iterate, const IterationRow& last) {
  if (input.interpolation) return {};
  std::vector<std::string> warnings;
  const auto add = [&warnings](std::optional<std::string> warning) {
    if (warning) warnings.push_back(std::move(*warning));
  };
  const ErrorNorms error = targeted_error(input, last);
  if (!is_round_off(error.l2, iterate.mesh, iterate.values)) add(hint_of_correction(input.targets, error, last));
  add(of_unseen_source(input.problem, last));
  for (std::string& warning : of_idle_point_sources(input.problem, iterate.mesh))
    warnings.push_back(std::move(warning));
  add(warn_of_jumps(input.problem, iterate.mesh));
  return warnings;
}

}  // namespace parmesan
