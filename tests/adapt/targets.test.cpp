#include "adapt/targets.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace parmesan;

TEST_CASE("target_excess is the largest error over its target, falling like 1 / N", "[adapt][targets]") {
  Targets targets;
  ErrorNorms error;
  error.l2 = 3e-3;
  error.h1 = 0.2;
  CHECK(target_excess(targets, error) == 3e-3);
  targets.l2_error = 1e-3;
  CHECK(target_excess(targets, error) == Approx(3.0).epsilon(1e-12));
  targets.h1_error = 0.1;  // 2, squared
  CHECK(target_excess(targets, error) == Approx(4.0).epsilon(1e-12));
  targets.linf_error = 1.0;
  error.linf = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isinf(target_excess(targets, error)));
}

TEST_CASE("metrics are made for H1 where only an H1 error is asked for", "[adapt][targets]") {
  Targets targets;
  CHECK(error_measure(targets) == ErrorMeasure::Lp);
  targets.h1_error = 0.1;
  CHECK(error_measure(targets) == ErrorMeasure::H1);
  targets.l2_error = 0.1;
  CHECK(error_measure(targets) == ErrorMeasure::Lp);
}
