#include "adapt/loop_warnings.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "adapt/adapt_loop.h"
#include "tests/adapt/loop_cases.h"
#include "tests/support/meshes.h"

using namespace parmesan;

TEST_CASE("discontinuity capturing that does not converge is warned of", "[adapt][loop]") {
  const auto warning_after = [](double change) {
    IterationRow row;
    row.solve_report.emplace();
    row.solve_report->unknowns = 1;
    row.solve_report->capturing_steps = 20;
    row.solve_report->capturing_change = change;
    std::string all;
    for (const std::string& warning : warnings_of_last(row, std::nullopt, false, StopReason::ErrorTarget))
      all += warning + "\n";
    return all;
  };
  CHECK(warning_after(0.9e-3).find("capturing") == std::string::npos);
  CHECK_THAT(warning_after(0.02),
             Catch::Contains("discontinuity capturing does not converge on the last mesh: its last "
                             "step of 20 changed the solution by 0.02 of its range"));
}

TEST_CASE("an exact function without an L2 norm is warned of, and its data are not blamed", "[adapt][loop]") {
  const auto warnings_with = [](double doubt) {
    IterationRow row;
    row.solution_error = ErrorNorms{.l2 = 1.0};
    row.interpolation_error = ErrorNorms{.l2 = 1e-3, .l2_doubt = doubt};
    row.estimated_error = EstimatedError{.l2 = 1e-3};
    std::string all;
    for (const std::string& warning : warnings_of_last(row, std::nullopt, false, StopReason::Vertices))
      all += warning + "\n";
    return all;
  };
  CHECK_THAT(warnings_with(0.28), Catch::Contains("cannot be told") && Catch::Contains("28 % of its square"));
  CHECK(warnings_with(0.28).find("another solution") == std::string::npos);
  CHECK(warnings_with(1e-3).find("cannot be told") == std::string::npos);
  CHECK_THAT(warnings_with(1e-3), Catch::Contains("another solution"));
}

TEST_CASE("residuals tell of unresolved data, but not at Peclet numbers where they grow with these", "[adapt][loop]") {
  const auto is_warned = [](double residual, double peclet) {
    IterationRow row;
    row.solve_report.emplace();
    row.solve_report->unknowns = 1;
    row.solve_report->peclet_max = peclet;
    row.estimated_error = EstimatedError{.h1 = 1.0};
    row.residual_h1 = residual;
    const auto warnings = warnings_of_last(row, std::nullopt, false, StopReason::Vertices);
    return std::ranges::any_of(warnings, [](const std::string& w) { return w.find("not resolve") != w.npos; });
  };
  CHECK(is_warned(2.0, 0.0));
  CHECK(is_warned(2.0, 3500.0));
  CHECK_FALSE(is_warned(1.0, 0.0));
  CHECK_FALSE(is_warned(8.0, 7e4));
}

TEST_CASE("nothing is said of round-off", "[adapt][loop]") {
  const auto warnings = adapt(support::poisson_case("x + y", R"({"l2_error": 1e-20, "max_vertices": 300})"), {});
  CHECK(is_round_off(warnings.summary.iterations.back().solution_error->l2, warnings.last.mesh,
                     std::vector<double>{2.0}));
  for (const std::string& warning : warnings.summary.warnings) {
    CHECK(warning.find("cannot be told") == std::string::npos);
    CHECK(warning.find("defect_correction") == std::string::npos);
  }
}

TEST_CASE("a source or a function that the first mesh misses is told of, with the cure", "[adapt][loop][errors]") {
  const std::string peak = "1e-120 + exp(-1e8*((x-0.3)^2+(y-0.7)^2))";
  CHECK_THROWS_WITH(adapt(support::interpolation_case(peak, "{}"), {}),
                    Catch::Contains("\"vertices\" of 'initial'") && Catch::Contains("other units"));
  const auto says = [](const std::string& source) {
    const Case input =
        parse_case(R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}, "problem": {"source": )" + source +
                       R"(, "boundary": {"*": {"dirichlet": 0}}},
        "initial": {"vertices": 100}, "targets": {"vertices": 100, "max_iterations": 1}})",
                   "case.json");
    const auto warnings = adapt(input, {}).summary.warnings;
    return std::ranges::any_of(warnings, [](const std::string& w) { return w.find("is 0 at all") != w.npos; });
  };
  CHECK(says("\"1e10*exp(-1e8*((x-0.3)^2+(y-0.7)^2))\""));
  CHECK_FALSE(says("\"exp(-10*((x-0.3)^2+(y-0.7)^2))\""));
  CHECK_FALSE(says("0"));
}

TEST_CASE("who wants a small L2 error is told of defect correction where Galerkin's method adds most of it",
          "[adapt][loop]") {
  Targets targets;
  targets.l2_error = 1e-3;
  const ErrorNorms error{.l2 = 5e-3};
  IterationRow row;
  row.solve_report.emplace();
  row.solve_report->unknowns = 100;
  row.estimated_error = EstimatedError{.l2 = 5e-3, .h1 = 1.0, .linf = 1e-2, .interpolation_l2 = 1e-3};
  CHECK_THAT(hint_of_correction(targets, error, row).value_or(""),
             Catch::Contains("5 times") && Catch::Contains("\"defect_correction\": true"));
  SECTION("not where the interpolant is hardly better") { row.estimated_error->interpolation_l2 = 3e-3; }
  SECTION("its known error counts before the estimate") { row.interpolation_error = ErrorNorms{.l2 = 4e-3}; }
  SECTION("not where only gradients are wanted") {
    targets.l2_error.reset();
    targets.h1_error = 1.0;
  }
  SECTION("not where values are corrected") { row.solve_report->correction_steps = 2; }
  SECTION("not where that is refused: with goals and captured discontinuities") {
    if (GENERATE(false, true)) {
      row.goal.emplace();
    } else {
      row.solve_report->capturing_steps = 3;
    }
  }
  SECTION("not where nothing is known") { row.estimated_error.reset(); }
  CHECK_FALSE(hint_of_correction(targets, error, row));
}

TEST_CASE("what is round-off does not depend on the unit of length", "[adapt][loop]") {
  Mesh mesh = support::rectangle_mesh(3, 3);
  for (Point& p : mesh.points) p = {1e-10 * p.x, 1e-10 * p.y};
  const std::vector<double> values{2.0};
  CHECK_FALSE(is_round_off(1e-14, mesh, values));  // 1e-4 of the solution
  CHECK(is_round_off(1e-24, mesh, values));
}

TEST_CASE("a point source where the solution is given is told of", "[adapt][loop]") {
  const auto warned = [](const std::string& place) {
    const Case input = parse_case(R"({"name": "test", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
        "problem": {"boundary": {"right": {"dirichlet": 0}, "*": {"neumann": 0}},
                    "point_sources": [{"at": )" +
                                      place + R"(, "strength": 2}]},
        "targets": {"vertices": 100, "max_iterations": 1}, "mesher": {"preset": "fast"}})",
                                  "test.json");
    return std::ranges::any_of(adapt(input, {}).summary.warnings,
                               [](const std::string& w) { return w.find("it changes nothing") != w.npos; });
  };
  CHECK(warned("[1, 0.4]"));
  CHECK_FALSE(warned("[0, 0.4]"));
  CHECK_FALSE(warned("[0.99, 0.4]"));
}
