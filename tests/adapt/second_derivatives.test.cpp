#include "adapt/second_derivatives.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/adapt/loop_cases.h"
#include "tests/support/meshes.h"

using namespace parmesan;

TEST_CASE("second_derivatives keep their sign where the error is to be lowered", "[adapt][loop]") {
  // u = x^2 - 3xy - y^2: H = [2 -3; -3 -2] everywhere; least squares recover it on any mesh.
  Case input = support::interpolation_case("x^2 - 3*x*y - y^2", "{}");
  input.metric.exact_hessian = GENERATE(false, true);
  Iterate iterate;
  iterate.mesh = support::random_square(6, 0.2, 1);
  compute_values(input, iterate, nullptr);
  CHECK_FALSE(second_derivatives(input, iterate).signed_field);
  input.lower_error = true;
  const SecondDerivatives found = second_derivatives(input, iterate);
  REQUIRE(found.signed_field);
  CHECK(found.absolute.size() == iterate.mesh.points.size());
  MetricHint hint = -1;
  const SymmetricTensor h = found.signed_field->at({0.3, 0.6}, hint);
  CHECK(h.xx == Approx(2.0).epsilon(1e-8));
  CHECK(h.xy == Approx(-3.0).epsilon(1e-8));
  CHECK(h.yy == Approx(-2.0).epsilon(1e-8));
}

TEST_CASE("kinks where materials meet are no second derivatives", "[adapt][loop]") {
  // u = (x - 1/2) / K + (x - 1/2)^2 / 2, the last term on the left only or on both sides.
  Case input = support::poisson_case("0", "{}");
  input.problem.diffusion = [](const Point&, int region) {
    return region == 1 ? Diffusion{5, 0, 5} : Diffusion{1, 0, 1};
  };
  input.lower_error = true;
  Iterate iterate;
  iterate.mesh = support::two_regions(8, 7, 1);
  const bool both = GENERATE(false, true);
  for (const Point& p : iterate.mesh.points) {
    const bool left = p.x < 0.5;
    const double curved = left || both ? ((p.x - 0.5) * (p.x - 0.5)) / 2 : 0.0;
    iterate.values.push_back((p.x - 0.5) / (left ? 5.0 : 1.0) + curved);
  }
  const SecondDerivatives found = second_derivatives(input, iterate);
  REQUIRE(found.absolute.size() == iterate.mesh.points.size());
  for (std::size_t v = 0; v < found.absolute.size(); ++v) {
    const Point& p = iterate.mesh.points[v];
    const SymmetricTensor& h = found.absolute[v].tensor;
    INFO("at " << p.x << ", " << p.y);
    if (p.x < 0.5 || both) CHECK(h.xx == Approx(1.0).epsilon(1e-6));
    if (p.x > 0.5 && !both) CHECK(std::abs(h.xx) < 1e-6);
    if (p.x == 0.5 && !both) CHECK((h.xx > 0.2 && h.xx < 0.8));  // a mean of the two
    CHECK(std::abs(h.yy) < 1e-6);
  }
  MetricHint hint = -1;
  CHECK(found.signed_field->at({0.25, 0.5}, hint).xx == Approx(1.0).epsilon(1e-6));
}
