#include "adapt/adapt_loop.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "adapt/continuation.h"
#include "adapt/diffusion_jumps.h"
#include "adapt/influence.h"
#include "adapt/loop_warnings.h"
#include "adapt/measure.h"
#include "adapt/second_derivatives.h"
#include "adapt/stopwatch.h"
#include "adapt/targets.h"
#include "mesher/errors.h"
#include "mesher/metric/complexity.h"
#include "mesher/metric/tensor_interpolant.h"

namespace parmesan {
namespace {

// The mesher gives a little more or less than was asked.
constexpr double cap_margin = 0.98;
constexpr int max_tries = 3;  // to make a mesh within the budget

SizeGoal size_goal(const Targets& targets) {
  SizeGoal goal;
  goal.error_targets = declares_error_target(targets);
  if (targets.vertices) goal.vertices = static_cast<double>(*targets.vertices);
  goal.max_passes = targets.max_iterations;
  goal.may_shrink = !targets.max_seconds;
  if (targets.max_vertices) goal.cap = cap_margin * static_cast<double>(*targets.max_vertices);
  if (goal.vertices && (goal.error_targets || (goal.cap && *goal.cap < *goal.vertices))) {
    goal.cap = std::min(goal.cap.value_or(HUGE_VAL), *goal.vertices);
    goal.vertices.reset();
  }
  return goal;
}

bool same_mesh(const Mesh& a, const Mesh& b) { return a.points == b.points && a.triangles == b.triangles; }

/// Runs the loop from the state it is given, or from the start.
class Loop {
 public:
  Loop(const Case& input, const LoopOptions& options) : case_(input), options_(options) {
    goal_ = size_goal(input.targets);                  // g++ 12 crashes on it in the list above
    if (options.isotropic) case_.lower_error = false;  // its best triangles are anisotropic
    case_.mesher.max_vertices = options.max_vertices;
    require_within_limit(input.targets, options.max_vertices);
  }

  LoopResult run() {
    if (options_.resume && !was_interrupted_at_start(*options_.resume)) {
      state_ = *options_.resume;
      state_.summary.threads = options_.threads;
    } else {
      start();
      add_row();
    }
    SizeDecision decision = decide();
    while (!decision.stop && advance(decision.asked, state_.summary.iterations.back().seconds)) {
      add_row();
      decision = decide();
    }
    if (decision.stop && *decision.stop != StopReason::Interrupted && return_to_met())
      decision.stop = StopReason::ErrorTarget;
    Summary& summary = state_.summary;
    summary.stop_reason = decision.stop.value_or(StopReason::Interrupted);
    if (summary.stop_reason == StopReason::ErrorTarget && case_.targets.goal_error)
      summary.stop_reason = StopReason::GoalTarget;
    const std::optional<std::int64_t> aimed = goal_.vertices ? case_.targets.vertices : std::nullopt;
    for (std::string& warning :
         warnings_of_last(summary.iterations.back(), aimed, state_.limits_bind, summary.stop_reason))
      summary.warnings.push_back(std::move(warning));
    if (!case_.interpolation) {
      if (std::optional<std::string> jumps = warn_of_jumps(case_.problem, state_.last.mesh))
        summary.warnings.push_back(std::move(*jumps));
    }
    summary.targets_met = goal_.error_targets ? state_.history.back().error <= 1.0
                                              : summary.stop_reason != StopReason::Interrupted && has_size_aimed_at();
    return {std::move(summary), std::move(state_.last), state_.limit};
  }

 private:
  // In the middle of a continuation, of which nothing is kept.
  bool was_interrupted_at_start(const LoopState& state) const {
    return case_.continuation > 1.0 && state.history.size() == 1 && !state.history.front().adapted;
  }

  void start() {
    Summary& summary = state_.summary;
    summary.case_name = case_.name;
    summary.seed = case_.mesher.seed;
    summary.threads = options_.threads;
    summary.error_targets_declared = goal_.error_targets;
    state_.limit = options_.limit;
    if (options_.start) {
      state_.last = *options_.start;
      state_.last.seconds = {};
      state_.asked = static_cast<double>(state_.last.mesh.num_vertices());
    } else {
      start_uniform();
    }
    if (case_.given) {
      if (std::optional<std::string> beyond = warn_beyond(*case_.given, state_.last.mesh))
        summary.warnings.push_back(std::move(*beyond));
    }
    if (case_.exact && !state_.limit) state_.limit = interpolation_limit(state_.last.mesh, *case_.exact);
    if (state_.limit && efficiency(1.0, 1.0, *state_.limit)) summary.interpolation_limit = state_.limit->value;
  }

  void start_uniform() {
    double asked = static_cast<double>(case_.initial_vertices);
    if (goal_.cap) asked = std::min(asked, *goal_.cap);
    if (goal_.vertices) asked = std::min(asked, *goal_.vertices);
    state_.asked = asked;
    state_.last = uniform_iterate(case_, asked);
    if (case_.continuation > 1.0) {
      continue_in_diffusion();
    } else {
      compute_values(case_, state_.last, nullptr);
    }
  }

  // From each problem's solution a mesh for the next one; the last is the case's own, which is solved in any case.
  void continue_in_diffusion() {
    const Case own = case_;
    StageSeconds seconds;
    try {
      for (const double factor : continuation_factors(own.continuation)) {
        if (!may_continue()) break;
        case_ = with_larger_diffusion(own, factor);
        pass_stage(seconds);
      }
    } catch (const ProblemError&) {
      state_.last.values.clear();  // flux data may balance for the case's own diffusion only
    }
    case_ = own;
    is_continued_ = pass_stage(seconds);
    state_.last.seconds += seconds;
    state_.unchanged = state_.limits_bind = false;
  }

  // Solves the first problem on the mesh that is there, each further one on a mesh made from the solution before. True:
  // on such a mesh.
  bool pass_stage(StageSeconds& seconds) {
    seconds += std::exchange(state_.last.seconds, {});
    const bool has_values = !state_.last.values.empty();
    if (has_values && !interrupted() && advance(state_.asked, seconds)) return true;
    compute_values(case_, state_.last, nullptr);
    return false;
  }

  bool may_continue() const {
    return !interrupted() && !(case_.targets.max_seconds && lap_.seconds() >= *case_.targets.max_seconds);
  }

  // Measures the last iterate and reports it.
  void add_row() {
    Iterate& last = state_.last;
    std::vector<IterationRow>& rows = state_.summary.iterations;
    rows.push_back(measure(case_, last, static_cast<int>(rows.size()), state_.limit));
    for (std::string& warning : last.report.warnings) warn_once(std::move(warning));
    last.report.warnings.clear();
    const double excess = excess_of(rows.back());
    const bool adapted = rows.size() > 1 || options_.start || is_continued_;
    state_.history.push_back({state_.asked, static_cast<double>(last.mesh.num_vertices()), excess, adapted});
    remember_if_met();
    const Stopwatch now;
    state_.seconds += lap_.seconds();
    lap_ = now;
    if (options_.observer) options_.observer(state_);
  }

  // Each mesh repairs the same geometry again.
  void warn_once(std::string warning) {
    std::vector<std::string>& warnings = state_.summary.warnings;
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(std::move(warning));
  }

  void remember_if_met() {
    const bool is_smaller = !state_.met || state_.last.mesh.num_vertices() < state_.met->mesh.num_vertices();
    if (goal_.error_targets && state_.history.back().error <= 1.0 && is_smaller) state_.met = state_.last;
  }

  // Whether the error that was said to meet the targets was an estimate which a later mesh, at least as large, does not
  // bear out.
  bool is_refuted() const {
    const IterationRow& last = state_.summary.iterations.back();
    if (case_.interpolation || last.solution_error || (last.goal && last.goal->error)) return false;
    const auto vertices = static_cast<double>(state_.met->mesh.num_vertices());
    const auto is_met = [](const SizeStep& s) { return s.error <= 1.0; };
    const auto later =
        std::ranges::find_if(state_.history, [&](const SizeStep& s) { return is_met(s) && s.vertices == vertices; });
    return std::any_of(later, state_.history.end(),
                       [&](const SizeStep& s) { return !is_met(s) && s.vertices >= vertices; });
  }

  // A smaller mesh may miss what a larger one before it has met. True: the last row is that one's again.
  bool return_to_met() {
    if (!state_.met || state_.is_met || is_refuted()) return false;
    if (state_.history.back().error <= 1.0 && state_.last.mesh.num_vertices() <= state_.met->mesh.num_vertices())
      return false;
    state_.last = *state_.met;
    state_.last.seconds = {};  // which the row that met them has
    state_.is_met = true;
    add_row();
    return true;
  }

  // Where nothing is declared but a goal, what does not cancel out of its error.
  double excess_of(const IterationRow& row) const {
    if (row.goal && !goal_.error_targets) return row.goal->estimate.magnitude;
    return target_excess(case_.targets, targeted_error(case_, row), targeted_goal_error(row));
  }

  SizeDecision decide() const {
    if (state_.is_met) return {state_.asked, StopReason::ErrorTarget};
    SizeDecision decision = next_size(state_.history, goal_);
    if (decision.stop) return decision;
    decision.stop = budget_spent();
    const bool is_met = goal_.error_targets && state_.history.back().error <= 1.0;
    if (decision.stop && is_met && *decision.stop != StopReason::Interrupted) decision.stop = StopReason::ErrorTarget;
    return decision;
  }

  std::optional<StopReason> budget_spent() const {
    if (interrupted()) return StopReason::Interrupted;
    if (state_.unchanged) return StopReason::Unchanged;
    if (state_.limits_bind) return StopReason::Stagnated;
    const ErrorNorms error = targeted_error(case_, state_.summary.iterations.back());
    if (is_round_off(error.l2, state_.last.values)) return StopReason::Floor;
    const Targets& targets = case_.targets;
    if (static_cast<int>(state_.history.size()) >= targets.max_iterations) return StopReason::MaxIterations;
    if (targets.max_seconds && state_.seconds >= *targets.max_seconds) return StopReason::TimeBudget;
    return std::nullopt;
  }

  bool has_size_aimed_at() const {
    const std::optional<std::int64_t>& aimed = case_.targets.vertices;
    return !aimed || has_size(state_.last.mesh.num_vertices(), static_cast<double>(*aimed));
  }

  bool interrupted() const { return options_.interrupted && options_.interrupted->load(); }

  bool exceeds_budget(const Iterate& iterate) const {
    return case_.targets.max_vertices && iterate.mesh.num_vertices() > *case_.targets.max_vertices;
  }

  // Recovers, builds the metric for this many vertices, remeshes and solves. seconds: of the mesh before, get those for
  // the metric added. False: interrupted.
  bool advance(double asked, StageSeconds& seconds) {
    const Stopwatch recover;
    MetricRequest request;
    request.options = case_.metric;
    request.measure = options_.measure.value_or(error_measure(case_.targets));
    request.isotropic = options_.isotropic;
    request.complexity = complexity_for_vertices(asked) * calibration();
    const SecondDerivatives derivatives = second_derivatives(case_, state_.last);
    const HessianMetric metric = next_metric(derivatives, request);
    seconds.recover += recover.seconds();
    seconds.cpu += recover.cpu_seconds();
    if (interrupted()) return false;
    Iterate next = remesh(case_, state_.last, *derivatives.mesh, metric, derivatives.signed_field.get());
    for (int tries = 1; exceeds_budget(next) && tries < max_tries; ++tries) {
      request.complexity *= cap_margin * static_cast<double>(*case_.targets.max_vertices) / next.mesh.num_vertices();
      next = remesh(case_, state_.last, *derivatives.mesh, next_metric(derivatives, request),
                    derivatives.signed_field.get());
    }
    if (interrupted()) return false;
    compute_values(case_, next, &state_.last);
    if (interrupted()) return false;
    state_.unchanged = same_mesh(next.mesh, state_.last.mesh);
    const bool is_coarser = metric.complexity < 0.8 * request.complexity;  // so far off only for size limits
    const bool is_finer = metric.complexity > 1.25 * request.complexity;
    state_.limits_bind = state_.asked == asked && (is_coarser || (is_finer && goal_.vertices));
    state_.asked = is_finer && !goal_.vertices ? static_cast<double>(next.mesh.num_vertices()) : asked;
    state_.last = std::move(next);
    return true;
  }

  // For the norms, for the goal, or for both where targets of both are declared.
  HessianMetric next_metric(const SecondDerivatives& derivatives, const MetricRequest& request) {
    if (!case_.goal) return norm_metric(derivatives, request);
    MetricRequest for_goal = request;
    for_goal.measure = ErrorMeasure::Lp;
    for_goal.options.norm = 1.0;
    HessianMetric goal = metric_from_hessians(*derivatives.mesh, derivatives.goal, for_goal);
    if (!declares_norm_target(case_.targets)) return goal;
    return intersected(*derivatives.mesh, goal, norm_metric(derivatives, request), request);
  }

  // What Galerkin's method adds to the interpolation error is small in H1: only for L_p does it bound aspects.
  HessianMetric norm_metric(const SecondDerivatives& derivatives, MetricRequest request) {
    const bool bounds_aspects = case_.metric.automatic_aspect && request.measure == ErrorMeasure::Lp;
    if (bounds_aspects && !request.isotropic) request.influence = influence_at(*derivatives.mesh);
    return metric_from_hessians(*derivatives.mesh, derivatives.absolute, request);
  }

  // It varies as slowly as the distance to the boundary, so it is computed once, on a mesh of its own. Of what is
  // corrected some is left: a ninth by a comparison of cases (README.md).
  std::vector<SymmetricTensor> influence_at(const Mesh& mesh) {
    constexpr std::int64_t enough_vertices = 2000;
    constexpr double left_by_correction = 1.0 / 9.0;
    if (!influence_) {
      Case unlimited = case_;  // the same mesh whatever the safety limit is
      unlimited.mesher.max_vertices = std::max(case_.mesher.max_vertices, 2 * enough_vertices);
      const Mesh coarse = uniform_iterate(unlimited, static_cast<double>(enough_vertices)).mesh;
      influence_.emplace(coarse, influence(coarse, case_.problem));
    }
    const double left = case_.problem.correct_defect ? left_by_correction : 1.0;
    std::vector<SymmetricTensor> result;
    result.reserve(mesh.points.size());
    MetricHint hint;
    for (const Point& p : mesh.points) result.push_back(left * influence_->at(p, hint));
    return result;
  }

  // Complexity asked for per complexity that the vertices obtained stand for: boundary vertices make
  // meshes larger than 2 C / sqrt3.
  double calibration() const {
    if (state_.history.size() < 2) return 1.0;
    const double obtained = complexity_for_vertices(state_.history.back().vertices);
    return std::clamp(state_.last.complexity / obtained, 0.5, 1.1);
  }

  Case case_;
  const LoopOptions& options_;
  SizeGoal goal_;
  bool is_continued_ = false;  // the first mesh is that of a whole continuation
  std::optional<TensorInterpolant> influence_;
  Stopwatch lap_;  // since the last row
  LoopState state_;
};

}  // namespace

LoopResult adapt(const Case& input, const LoopOptions& options) { return Loop(input, options).run(); }

}  // namespace parmesan
