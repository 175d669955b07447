#include "adapt/measure.h"

#include <catch2/catch.hpp>

using namespace parmesan;

TEST_CASE("targeted_error is the solution's where known, else the estimate, else the interpolant's", "[adapt][loop]") {
  Case input;
  IterationRow row;
  row.estimated_error = EstimatedError{0.1, 0.2, 0.7};
  CHECK(targeted_error(input, row).l2 == 0.1);
  CHECK(targeted_error(input, row).linf == 0.7);
  row.solution_error = ErrorNorms{0, 0.3, 0, 0};
  CHECK(targeted_error(input, row).l2 == 0.3);
  input.interpolation = true;
  row.interpolation_error = ErrorNorms{0, 0.4, 0, 0};
  CHECK(targeted_error(input, row).l2 == 0.4);
}
