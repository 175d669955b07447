#include <catch2/catch.hpp>
#include <cmath>

#include "adapt/adapt_loop.h"
#include "adapt/functional_value.h"
#include "adapt/measure.h"
#include "tests/adapt/case_support.h"
#include "tests/adapt/loop_cases.h"

using namespace parmesan;
using support::goal_case;

TEST_CASE("the loop meets a goal target, and says that it was one", "[adapt][loop][goal]") {
  const LoopResult run =
      adapt(goal_case(R"({"value": [0.4, 0.45]})", R"({"goal_error": 1e-3, "max_vertices": 4000})"), {});
  CHECK(run.summary.stop_reason == StopReason::GoalTarget);
  CHECK(to_string(run.summary.stop_reason) == "goal_target");
  CHECK(run.summary.targets_met);
  const GoalRow& goal = run.summary.iterations.back().goal.value();
  const double exact = std::exp(-50 * (0.01 + 0.0025));
  CHECK(goal.value + *goal.error == Approx(exact).epsilon(1e-14));
  CHECK(std::abs(*goal.error) <= 1e-3);
  const auto row = to_json(run.summary.iterations.back());
  CHECK(row["goal"]["effectivity"].get<double>() == Approx(goal.estimate.error / *goal.error).epsilon(1e-12));
}

TEST_CASE("a goal target that cannot be met is missed", "[adapt][loop][goal]") {
  const LoopResult run = adapt(goal_case(R"({"integral": "*"})", R"({"goal_error": 1e-12, "max_vertices": 300})"), {});
  CHECK(run.summary.stop_reason == StopReason::VertexBudget);
  CHECK_FALSE(run.summary.targets_met);
}

TEST_CASE("targets of a norm and of a goal are met by one mesh", "[adapt][loop][goal]") {
  const LoopResult run =
      adapt(goal_case(R"({"flux": "top"})", R"({"goal_error": 1e-4, "l2_error": 2e-3, "max_vertices": 9000})"), {});
  CHECK(run.summary.stop_reason == StopReason::GoalTarget);
  const IterationRow& last = run.summary.iterations.back();
  CHECK(last.solution_error->l2 <= 2e-3);
  CHECK(std::abs(last.goal->error.value()) <= 1e-4);
}

TEST_CASE("an estimate that nearly cancels out is not believed", "[adapt][loop][goal]") {
  IterationRow row;
  CHECK(std::isnan(targeted_goal_error(row)));
  row.goal = GoalRow{1.0, {-0.01, 4.0}, std::nullopt};
  CHECK(targeted_goal_error(row) == 1.0);
  row.goal->estimate.error = -3.0;
  CHECK(targeted_goal_error(row) == 3.0);
  row.goal->error = -0.5;
  CHECK(targeted_goal_error(row) == 0.5);
}

TEST_CASE("what chords in place of arcs do to a goal is estimated", "[adapt][loop][goal][curves]") {
  struct Problem {
    std::string geometry, problem, goal;
  };
  const std::string disc = R"j("disc": {"radius": 1})j";
  const std::string plate = R"j("rectangle": {"min": [-2, -2], "max": [2, 2]},
      "holes": [{"disc": {"radius": 1}, "label": "hole"}])j";
  const std::string cold = R"j("exact": "1 - x^2 - y^2", "boundary": {"*": {"dirichlet": 0}})j";
  const std::string windy =
      R"j("exact": "(1 - x^2 - y^2)*exp(x)", "velocity": [3, 1], "boundary": {"*": {"dirichlet": 0}})j";
  const std::string well =
      R"j("exact": "log(x^2 + y^2)", "boundary": {"hole": {"dirichlet": 0}, "*": {"dirichlet": "exact"}})j";
  const std::string pillar =
      R"j("exact": "x*(1 + 1/(x^2 + y^2))", "boundary": {"hole": {"neumann": 0}, "*": {"dirichlet": "exact"}})j";
  const std::string integral = R"j({"integral": "*"})j", moment = R"j({"integral": "*", "weight": "x"})j";
  const Problem of =
      GENERATE_COPY(Problem{disc, cold, integral}, Problem{disc, windy, moment}, Problem{plate, well, integral},
                    Problem{plate, well, R"j({"flux": "hole"})j"}, Problem{plate, pillar, moment});
  const std::string text = R"j({"name": "test", "geometry": {)j" + of.geometry + R"j(}, "problem": {)j" + of.problem +
                           R"j(}, "functionals": {"goal": )j" + of.goal +
                           R"j(}, "targets": {"goal_error": 1e-12, "max_vertices": 1000, "max_iterations": 3},
      "initial": {"vertices": 800}})j";
  const GoalRow goal = adapt(parse_case(text, "test.json"), {}).summary.iterations.back().goal.value();
  CAPTURE(of.geometry, of.problem, of.goal);
  CHECK(goal.estimate.error == Approx(*goal.error).epsilon(0.06));  // 0.33, 0.6, -0.6, 1.6 and 0.7 of it without
}

TEST_CASE("a mesh for a goal has more vertices where solution and dual solution bend", "[adapt][loop][goal]") {
  // A wind carries a source from the left to the right; the goal lies in the middle: what is behind it does not matter.
  const auto vertices_behind = [](const std::string& goal) {
    const Case input = parse_case(R"case({"geometry": {"rectangle": {"min": [0, 0], "max": [4, 1]}},
        "problem": {"diffusion": 0.02, "velocity": [1, 0], "source": "exp(-((x - 0.5)^2 + (y - 0.5)^2)/0.01)",
          "boundary": {
    "left" : {"dirichlet" : 0}, "*" : { "neumann" : 0 }}},
        "functionals": {"there": {"integral": "*", "weight": "exp(-((x - 2)^2 + (y - 0.3)^2)/0.02)"}},
        "targets": {"vertices": 400, "max_iterations": 6)case" +
                                      goal + R"(}, "initial": {"vertices": 100}, "mesher": {"preset": "fast"}})",
                                  "test.json");
    const LoopResult run = adapt(input, {});
    int count = 0;
    for (const Point& p : run.last.mesh.points) count += p.x > 2.5 ? 1 : 0;
    return count;
  };
  CHECK(vertices_behind(R"(, "goal": "there")") < 0.5 * vertices_behind(""));
}

TEST_CASE("The exact value of a functional is given, or integrated from the exact solution", "[adapt][goal]") {
  const auto value = [](const std::string& functional) {
    const Case input = goal_case(functional, R"({"goal": "goal"})");
    return exact_value(input, *input.goal, uniform_iterate(input, 100).mesh);
  };
  CHECK(value(R"({"value": [0.5, 0.5]})") == 1.0);
  CHECK(value(R"({"value": [0.5, 0.5], "exact": 7})") == 7.0);
  // int exp(-50 t^2) over (-1/2, 1/2) = sqrt(pi/50) erf(sqrt(12.5)); squared for the square.
  const double line = std::sqrt(M_PI / 50) * std::erf(std::sqrt(12.5));
  CHECK(value(R"({"integral": "*"})").value() == Approx(line * line).epsilon(1e-6));
  CHECK(value(R"({"boundary_integral": "top"})").value() == Approx(line * std::exp(-12.5)).epsilon(1e-6));
  CHECK(value(R"({"flux": "top"})").value() == Approx(-50 * line * std::exp(-12.5)).epsilon(1e-6));
}

TEST_CASE("A goal that cannot be is refused with what there is", "[adapt][case][goal][errors]") {
  const auto issue = [](const std::string& functionals, const std::string& targets) {
    return support::issue_text(support::case_text(
        support::kZeroBoundary, R"(, "functionals": {)" + functionals + R"(}, "targets": {)" + targets + "}"));
  };
  const std::string two = R"("mean": {"integral": "*"}, "spot": {"value": [0.5, 0.5]})";
  CHECK(issue(two, R"("goal_error": 1)") ==
        "/targets/goal_error: needs 'goal', the name of a functional. There are: 'mean', 'spot'\n");
  CHECK_THAT(issue("", R"("goal_error": 1)"), Catch::Contains("There are: none"));
  CHECK(issue(two, R"("goal": "spt")") ==
        "/targets/goal: there is no functional 'spt'; did you mean 'spot'? There are: 'mean', 'spot'\n");
  CHECK(issue(two, R"("goal": "spot", "goal_error": 1e-3)").empty());
  CHECK_THAT(support::issue_text(support::case_text(R"("interpolate": "x")", R"(, "functionals":
      {"f": {"integral": "*"}}, "targets": {"goal_error": 1})")),
             Catch::Contains("has no goal; give an equation"));
}
