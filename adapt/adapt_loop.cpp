#include "adapt/adapt_loop.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "adapt/continuation.h"
#include "adapt/loop_decision.h"
#include "adapt/loop_warnings.h"
#include "adapt/measure.h"
#include "adapt/next_metric.h"
#include "adapt/number_text.h"
#include "adapt/second_derivatives.h"
#include "adapt/stopwatch.h"
#include "adapt/targets.h"
#include "mesher/metric/complexity.h"

namespace parmesan {
namespace {

constexpr int max_tries = 3;  // to make a mesh within the budget

bool same_mesh(const Mesh& a, const Mesh& b) { return a.points == b.points && a.triangles == b.triangles; }

/// Runs the loop from the state it is given, or from the start.
class Loop {
 public:
  Loop(const Case& input, const LoopOptions& options, const LoopStart& start)
      : case_(input), options_(options), start_(start) {
    goal_ = size_goal(input.targets);                  // g++ 12 crashes on it in the list above
    if (options.isotropic) case_.lower_error = false;  // its best triangles are anisotropic
    case_.mesher.max_vertices = options.max_vertices;
    require_within_limit(input.targets, options.max_vertices);
  }

  LoopResult run() {
    if (start_.resume && !was_interrupted_at_start(*start_.resume)) {
      state_ = *start_.resume;
      state_.summary.threads = options_.threads;
      if (start_.is_other_case) judge_anew();
    } else {
      start();
      add_row();
    }
    SizeDecision decision = decide(case_, state_, interrupted());
    while (!decision.stop && advance(decision.asked, state_.summary.iterations.back().seconds)) {
      add_row();
      decision = decide(case_, state_, interrupted());
    }
    if (decision.stop && *decision.stop != StopReason::Interrupted && return_to_met())
      decision.stop = StopReason::ErrorTarget;
    finish(decision.stop.value_or(StopReason::Interrupted));
    return {std::move(state_.summary), std::move(state_.last), state_.limit};
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
    if (start_.first) {
      state_.last = *start_.first;
      state_.last.seconds = {};
      state_.asked = static_cast<double>(state_.last.mesh.num_vertices());
    } else {
      start_uniform();
    }
    if (case_.given) {
      if (std::optional<std::string> beyond = warn_beyond(*case_.given, state_.last.mesh))
        summary.warnings.push_back(std::move(*beyond));
    }
    find_limit();
  }

  // Goes on from the mesh of another case: what was found out there says nothing here.
  void judge_anew() {
    state_.met.reset();
    state_.is_met = state_.unchanged = state_.limits_bind = false;
    state_.summary.case_name = case_.name;
    state_.summary.error_targets_declared = goal_.error_targets;
    for (SizeStep& step : state_.history) step.error = HUGE_VAL;
    find_limit();
    compute_values(case_, state_.last, nullptr);
    add_row();
  }

  // Of interpolation, where the exact function is known.
  void find_limit() {
    Summary& summary = state_.summary;
    state_.limit = start_.limit;
    if (case_.exact && !state_.limit) state_.limit = interpolation_limit(state_.last.mesh, *case_.exact);
    if (state_.limit && efficiency(1.0, 1.0, *state_.limit)) summary.interpolation_limit = state_.limit->value;
  }

  void start_uniform() {
    double asked = static_cast<double>(case_.initial_vertices);
    if (goal_.cap) asked = std::min(asked, *goal_.cap);
    if (goal_.vertices) asked = std::min(asked, *goal_.vertices);
    if (asked < static_cast<double>(case_.initial_vertices) && case_.initial_vertices > Case{}.initial_vertices) {
      state_.summary.warnings.push_back("the first mesh was asked for " + short_number(asked, 10) +
                                        " vertices, not the " + std::to_string(case_.initial_vertices) +
                                        " of 'initial': 'targets' allow no more");
    }
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

  // Norms of a part of the domain say nothing of a target.
  void require_measured(const IterationRow& row) const {
    constexpr double negligible = 0.01;
    const double left_out = targeted_error(case_, row).left_out;
    if (!declares_norm_target(case_.targets) || left_out <= negligible) return;
    throw ProblemError("/targets: errors cannot be measured, for \"" + case_.exact->text() + "\" is not finite on " +
                       short_number(100.0 * left_out, 3) + " % of the domain");
  }

  // Measures the last iterate and reports it.
  void add_row() {
    Iterate& last = state_.last;
    std::vector<IterationRow>& rows = state_.summary.iterations;
    rows.push_back(measure(case_, last, static_cast<int>(rows.size()), state_.limit));
    require_measured(rows.back());
    for (std::string& warning : last.report.warnings) warn_once(std::move(warning));
    last.report.warnings.clear();
    const double excess = excess_of(case_, rows.back());
    const bool adapted = rows.size() > 1 || start_.first || is_continued_;
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

  // A smaller mesh may miss what a larger one before it has met. True: the last row is that one's again.
  bool return_to_met() {
    if (!state_.met || state_.is_met || is_refuted(case_, state_)) return false;
    if (state_.history.back().error <= 1.0 && state_.last.mesh.num_vertices() <= state_.met->mesh.num_vertices())
      return false;
    state_.last = *state_.met;
    state_.last.seconds = {};  // which the row that met them has
    state_.is_met = true;
    add_row();
    return true;
  }

  void finish(StopReason reason) {
    Summary& summary = state_.summary;
    const bool is_of_goal = reason == StopReason::ErrorTarget && case_.targets.goal_error;
    summary.stop_reason = is_of_goal ? StopReason::GoalTarget : reason;
    const std::optional<std::int64_t> aimed = goal_.vertices ? case_.targets.vertices : std::nullopt;
    for (std::string& warning :
         warnings_of_last(summary.iterations.back(), aimed, state_.limits_bind, summary.stop_reason))
      summary.warnings.push_back(std::move(warning));
    for (std::string& warning : warnings_of_solution(case_, state_.last, summary.iterations.back()))
      summary.warnings.push_back(std::move(warning));
    summary.targets_met = goal_.error_targets ? state_.history.back().error <= 1.0
                                              : reason != StopReason::Interrupted && has_size_aimed_at(case_, state_);
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
    const Targets& aims = options_.aims ? *options_.aims : case_.targets;
    request.measure = error_measure(aims);
    request.norms = declares_norm_target(aims);
    request.isotropic = options_.isotropic;
    const double wanted = complexity_for_vertices(asked) * calibration();
    request.complexity = wanted;
    const SecondDerivatives derivatives = second_derivatives(case_, state_.last);
    const HessianMetric metric = next_metric_.make(case_, derivatives, request);
    seconds.recover += recover.seconds();
    seconds.cpu += recover.cpu_seconds();
    if (interrupted()) return false;
    Iterate next = remesh(case_, state_.last, *derivatives.mesh, metric, derivatives.signed_field.get());
    for (int tries = 1; exceeds_budget(next) && tries < max_tries; ++tries) {
      request.complexity *= cap_margin * static_cast<double>(*case_.targets.max_vertices) / next.mesh.num_vertices();
      next = remesh(case_, state_.last, *derivatives.mesh, next_metric_.make(case_, derivatives, request),
                    derivatives.signed_field.get());
    }
    if (interrupted()) return false;
    compute_values(case_, next, &state_.last);
    if (interrupted()) return false;
    state_.unchanged = same_mesh(next.mesh, state_.last.mesh);
    const bool is_coarser = metric.complexity < 0.8 * wanted;  // so far off only for size limits
    const bool is_finer = metric.complexity > 1.25 * wanted;
    const bool is_last_size = goal_.vertices && asked >= *goal_.vertices;
    state_.limits_bind = state_.asked == asked && (is_coarser || (is_finer && is_last_size));
    const auto obtained = static_cast<double>(next.mesh.num_vertices());
    state_.asked = is_finer && !is_last_size ? std::min(obtained, goal_.vertices.value_or(obtained)) : asked;
    state_.last = std::move(next);
    return true;
  }

  // Complexity asked for per complexity that the vertices obtained stand for: boundary vertices make
  // meshes larger than 2 C / sqrt3. The mesh of a given field may be any number of times as large as the domain.
  double calibration() const {
    if (state_.history.size() < 2) return 1.0;
    const double obtained = complexity_for_vertices(state_.history.back().vertices);
    return std::clamp(state_.last.complexity / obtained, 0.5, case_.given ? HUGE_VAL : 1.1);
  }

  Case case_;
  const LoopOptions& options_;
  const LoopStart& start_;
  SizeGoal goal_;
  bool is_continued_ = false;  // the first mesh is that of a whole continuation
  NextMetric next_metric_;
  Stopwatch lap_;  // since the last row
  LoopState state_;
};

}  // namespace

LoopResult adapt(const Case& input, const LoopOptions& options, const LoopStart& start) {
  return Loop(input, options, start).run();
}

}  // namespace parmesan
