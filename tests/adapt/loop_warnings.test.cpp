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
