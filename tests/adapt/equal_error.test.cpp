#include "adapt/equal_error.h"

#include <catch2/catch.hpp>
#include <vector>

using namespace parmesan;

TEST_CASE("size_for_error interpolates on log-log lines", "[adapt][compare]") {
  const std::vector<double> sizes{100, 10000};
  const std::vector<double> errors{1.0, 0.01};  // error = 100 / N
  const EqualError e = size_for_error(sizes, errors, 0.1);
  CHECK(e.found == EqualError::Found::Interpolated);
  CHECK(e.size == Approx(1000.0).epsilon(1e-12));
  CHECK(size_for_error(sizes, errors, 0.01).size == Approx(10000.0).epsilon(1e-12));
}

TEST_CASE("size_for_error says so instead of extrapolating", "[adapt][compare]") {
  const std::vector<double> sizes{100, 400};
  const std::vector<double> errors{1.0, 0.5};
  CHECK(size_for_error(sizes, errors, 0.1).found == EqualError::Found::NotReached);
  CHECK(size_for_error(sizes, errors, 0.1).size == 400.0);
  CHECK(size_for_error(sizes, errors, 2.0).found == EqualError::Found::BelowSmallest);
}
