#include "adapt/loop_warnings.h"

#include <catch2/catch.hpp>

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
