#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "adapt/adapt_loop.h"
#include "adapt/measure.h"
#include "adapt/targets.h"
#include "tests/adapt/loop_cases.h"

using namespace parmesan;

namespace {

/// The case with other targets.
Case aimed(Case input, const Targets& targets) {
  input.targets = targets;
  return input;
}

/// The largest ratio of an error to its target after a run that aims at this many vertices instead.
double excess_with(const Case& input, double vertices) {
  Targets size;
  size.vertices = static_cast<std::int64_t>(vertices);
  const LoopResult run = adapt(aimed(input, size), {});
  return target_excess(input.targets, targeted_error(input, run.summary.iterations.back()));
}

}  // namespace

TEST_CASE("a tolerance costs at most 10 % more vertices than the smallest size that meets it, and 12 meshes",
          "[adapt][loop][slow]") {
  Case input = GENERATE(support::interpolation_case("tanh(20*(x - y^2))", R"({"l2_error": 5e-4})"),
                        support::interpolation_case("exp(-30*(x^2 + y^2))", R"({"linf_error": 3e-4})"),
                        support::poisson_case("exp(-50*((x - 0.5)^2 + (y - 0.5)^2))", R"({"l2_error": 2e-4})"),
                        support::poisson_case("atan(20*(hypot(x + 0.05, y + 0.05) - 0.7))", R"({"l2_error": 1e-3})"),
                        support::poisson_case("atan(20*(hypot(x + 0.05, y + 0.05) - 0.7))", R"({"h1_error": 0.2})"));
  input.mesher.preset = Preset::Good;
  input.initial_vertices = 400;  // 20 x 20
  input.targets.max_iterations = 12;
  const LoopResult run = adapt(input, {});
  const auto vertices = static_cast<double>(run.summary.iterations.back().vertices);
  const double most = input.targets.linf_error ? 1.25 : 1.10;  // which element is the worst is chance
  INFO(input.exact->text() << ", " << input.resolved["targets"].dump() << ": " << vertices << " vertices, "
                           << run.summary.iterations.size() << " meshes");
  CHECK(run.summary.stop_reason == StopReason::ErrorTarget);
  // Errors fall with size, up to the chance of single meshes: so no smaller size than these meets it.
  CHECK(excess_with(input, vertices / most) > 1.0);
  CHECK(excess_with(input, 0.75 * vertices) > 1.0);
}
