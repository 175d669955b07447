#include "adapt/trial.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/adapt/loop_cases.h"

using namespace parmesan;

TEST_CASE("a trial tells the vertices that the limit of interpolation asks for", "[adapt][check]") {
  // u = x^2 + y^2: sqrt|det H| = 2 everywhere, so N_T = 2 kappa / error with kappa = 2 / (3 sqrt5), and N_V = N_T / 2.
  const double expected = 2.0 / (3.0 * std::sqrt(5.0)) / 1e-4;
  const std::string target = R"({"l2_error": 1e-4})";
  for (const Case& input :
       {support::interpolation_case("x^2 + y^2", target), support::poisson_case("x^2 + y^2", target)}) {
    const Trial trial = try_out(input, 1'000'000);
    REQUIRE(trial.least_vertices);
    CHECK(*trial.least_vertices == Approx(expected).epsilon(0.01));
  }
}

TEST_CASE("a trial tells no vertices where the limit or the target is missing", "[adapt][check]") {
  const auto least = [](const std::string& function, const std::string& targets) {
    return try_out(support::interpolation_case(function, targets), 1'000'000).least_vertices;
  };
  CHECK_FALSE(least("x^2 + y^2", R"({"vertices": 1000})"));
  CHECK_FALSE(least("x^2", R"({"l2_error": 1e-4})"));  // det H = 0
}
