#include "adapt/order_fit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

using namespace parmesan;

TEST_CASE("fit_order finds the order of a power law exactly", "[adapt][compare]") {
  const std::vector<double> sizes{100, 400, 1600, 6400};
  std::vector<double> errors;
  for (const double n : sizes) errors.push_back(7.0 * std::pow(n, -0.75));
  const OrderFit fit = fit_order(sizes, errors);
  CHECK(fit.order == Approx(0.75).epsilon(1e-12));
  CHECK(fit.uncertainty < 1e-7);
  CHECK(fit.num_points == 4);
}

TEST_CASE("fit_order says how uncertain the order is", "[adapt][compare]") {
  // y = log error at x = 0, 1, 2 (units of log 10): 0, -0.9, -2.1. Slope -1.05; residuals 0.05, -0.1,
  // 0.05 squared sum 0.015; standard error sqrt(0.015 / 1 / 2) = 0.0866.
  const std::vector<double> errors{1.0, std::pow(10.0, -0.9), std::pow(10.0, -2.1)};
  const OrderFit fit = fit_order(std::vector<double>{1, 10, 100}, errors);
  CHECK(fit.order == Approx(1.05).epsilon(1e-10));
  CHECK(fit.uncertainty == Approx(std::sqrt(0.0075)).epsilon(1e-10));
}

TEST_CASE("fit_order leaves out what has no logarithm", "[adapt][compare]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> errors{1.0, nan, 0.25, 0.0};
  const OrderFit fit = fit_order(std::vector<double>{10, 20, 40, 80}, errors);
  CHECK(fit.num_points == 2);
  CHECK(fit.order == Approx(1.0).epsilon(1e-12));
  CHECK(fit_order(std::vector<double>{10}, std::vector<double>{1}).num_points == 0);
}
