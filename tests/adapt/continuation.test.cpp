#include "adapt/continuation.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adapt/adapt_loop.h"
#include "fem/solve.h"

using namespace parmesan;

namespace {

/// A layer of width 1e-3 along the flow.
Case convection_layer(const std::string& more) {
  return parse_case(R"case({"name": "layer", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
      "problem": {"diffusion": 1e-6, "velocity": [2, 1], "exact": "tanh(1000*(x - 2*y + 0.4))",
                  "boundary": {"*": {"dirichlet": "exact"}}},
      "functionals": {"mean": {"integral": "*"}}, "mesher": {"preset": "fast"}, )case" +
                        more + "}",
                    "test.json");
}

}  // namespace

TEST_CASE("continuation divides the diffusion by four, down to the case's own", "[adapt][continuation]") {
  CHECK(continuation_factors(1.0).empty());
  CHECK(continuation_factors(64.0) == std::vector{64.0, 16.0, 4.0});
  CHECK(continuation_factors(5.0) == std::vector{5.0, 1.25});
}

TEST_CASE("a stage of continuation has the diffusion times its factor", "[adapt][continuation]") {
  Case input = convection_layer(R"("targets": {"vertices": 300})");
  input.problem.diffusion = [](const Point& p, int region) { return Diffusion{p.x, p.y, 1.0 + region}; };
  const Case stage = with_larger_diffusion(input, 3.0);
  const Diffusion k = stage.problem.diffusion({2.0, 0.5}, 7);
  CHECK(k.xx == 6.0);
  CHECK(k.xy == 1.5);
  CHECK(k.yy == 24.0);
  CHECK_FALSE(stage.exact);
}

TEST_CASE("a loop that begins by continuation has found the layer with its first row", "[adapt][continuation]") {
  const auto first_row = [](const std::string& initial) {
    const Case input = convection_layer(R"("targets": {"vertices": 300, "max_iterations": 1}, "initial": )" + initial);
    return adapt(input, {}).summary.iterations.front();
  };
  const IterationRow uniform = first_row(R"({"vertices": 300})");
  const IterationRow continued = first_row(R"({"vertices": 300, "continuation": 4096})");
  CHECK(continued.solution_error->l2 < uniform.solution_error->l2 / 10);
  CHECK(continued.estimated_error->l2 < 4 * continued.solution_error->l2);
  CHECK(continued.seconds.cpu > uniform.seconds.cpu);
}

TEST_CASE("after continuation the case's own problem is solved, for a goal too", "[adapt][continuation][goal]") {
  for (const std::string goal : {"", R"(, "goal": "mean")"}) {
    const Case input = convection_layer(R"("targets": {"vertices": 300, "max_iterations": 1)" + goal +
                                        R"(}, "initial": {"vertices": 300, "continuation": 16})");
    const Iterate last = adapt(input, {}).last;
    CHECK((last.values == solve(last.mesh, input.problem).values));
    CHECK(last.dual.empty() == goal.empty());
  }
}

TEST_CASE("an interrupt during continuation leaves a row of the case's own problem, and a state to begin again from",
          "[adapt][continuation][slow]") {
  std::atomic<bool> interrupted{true};
  std::optional<LoopState> state;
  LoopOptions options;
  options.interrupted = &interrupted;
  options.observer = [&state](const LoopState& s) { state = s; };
  const std::string targets = R"("targets": {"vertices": 300, "max_iterations": 2}, "initial": {"vertices": 300)";
  const Case input = convection_layer(targets + R"(, "continuation": 16})");
  const LoopResult cut = adapt(input, options);
  const LoopState at_the_cut = state.value();
  const LoopResult uniform = adapt(convection_layer(targets + "}"), options);
  CHECK(cut.summary.stop_reason == StopReason::Interrupted);
  CHECK((cut.last.values == uniform.last.values));
  const LoopResult whole = adapt(input, {});
  interrupted = false;
  const LoopResult resumed = adapt(input, options, {.resume = &at_the_cut});
  CHECK(resumed.summary.iterations.size() == 2);
  CHECK((resumed.last.values == whole.last.values));
}

TEST_CASE("continuation passes over flux data that balance for the case's own diffusion only",
          "[adapt][continuation][nullspace]") {
  const auto first_of = [](const std::string& continuation) {
    return adapt(parse_case(R"case({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
        "problem": {"diffusion": 0.1, "velocity": [1, 0], "exact": "sin(3*x)*cos(2*y)",
                    "boundary": {"*": {"neumann": "exact"}}},
        "targets": {"vertices": 300, "max_iterations": 1}, "initial": {"continuation": )case" +
                                continuation + "}}",
                            "test.json"),
                 {})
        .last.values;
  };
  CHECK((first_of("100") == first_of("1")));
}

TEST_CASE("continuation ends with the time", "[adapt][continuation]") {
  const std::string targets = R"("targets": {"vertices": 300, "max_seconds": 1e-9}, "initial": {"vertices": 300)";
  const LoopResult hurried = adapt(convection_layer(targets + R"(, "continuation": 1e12})"), {});
  const LoopResult uniform = adapt(convection_layer(targets + "}"), {});
  CHECK(hurried.summary.stop_reason == StopReason::TimeBudget);
  CHECK((hurried.last.values == uniform.last.values));
}
