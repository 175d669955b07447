#include "adapt/size_limits.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "adapt/adapt_loop.h"
#include "adapt/hessian_metric.h"
#include "case_support.h"
#include "loop_cases.h"
#include "mesher/errors.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

MetricOptions varying(const std::string& h_min, const std::string& h_max) {
  MetricOptions options;
  options.h_min_at = Expression::parse(h_min);
  options.h_max_at = Expression::parse(h_max);
  return options;
}

}  // namespace

TEST_CASE("size limits that vary hold at every vertex", "[adapt][metric][limits]") {
  const Mesh mesh = support::random_square(8, 0.2, 9);
  MetricRequest request;
  request.options = varying("0.01*(1 + x)", "0.02 + 0.1*y");
  request.complexity = GENERATE(1.0, 1e7);
  std::vector<AbsoluteHessian> hessians(mesh.points.size(), {{3.0, 0.5, 1.0}, 0.0});
  const HessianMetric metric = metric_from_hessians(mesh, hessians, request);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Point& p = mesh.points[v];
    const Eigen2 e = eigen_decomposition(metric.metrics[v].tensor());
    CHECK(1.0 / std::sqrt(std::max(e.l1, e.l2)) >= 0.01 * (1.0 + p.x) * (1.0 - 1e-9));
    CHECK(1.0 / std::sqrt(std::min(e.l1, e.l2)) <= (0.02 + 0.1 * p.y) * (1.0 + 1e-9));
  }
}

TEST_CASE("clipped_sizes tells where each limit changes sizes", "[adapt][metric][limits]") {
  // Sizes 0.1 and 0.01 everywhere; h_min forbids the small one on the right, h_max the large one at the top.
  const Mesh mesh = support::rectangle_mesh(10, 10);
  const std::vector<Eigen2> metrics(mesh.points.size(), Eigen2{100.0, 1e4, {1.0, 0.0}});
  const auto limits = size_limits(mesh, varying("x > 0.75 ? 0.02 : 0.001", "y > 0.55 ? 0.05 : 1"));
  const ClippedSizes clipped = clipped_sizes(mesh, metrics, limits);
  CHECK(clipped.h_min.count == 3 * 11);
  CHECK(clipped.h_min.low.x == Approx(0.8).epsilon(1e-12));
  CHECK(clipped.h_min.high.x == Approx(1.0).epsilon(1e-12));
  CHECK(clipped.h_max.count == 5 * 11);
  CHECK(clipped.h_max.low.y == Approx(0.6).epsilon(1e-12));
  CHECK(clipped.h_max.low.x == 0.0);
  CHECK(clipped.aspect.count == 0);
}

TEST_CASE("sizes that are not positive, or contradict each other, are refused with the place",
          "[adapt][metric][limits][errors]") {
  const Mesh mesh = support::rectangle_mesh(4, 4);
  CHECK_THROWS_WITH(size_limits(mesh, varying("0.1 - x", "1")),
                    Catch::Contains("/metric/h_min") && Catch::Contains("at x = 0.25"));
  CHECK_THROWS_WITH(size_limits(mesh, varying("0.1", "1/x")),
                    Catch::Contains("/metric/h_max: the expression '1/x' is inf"));
  CHECK_THROWS_WITH(size_limits(mesh, varying("0.1", "x + 0.05")),
                    Catch::Contains("exceeds") && Catch::Contains("at x = 0, y = 0"));
  MetricOptions large;
  large.h_min = 1.0;
  CHECK_THROWS_WITH(size_limits(mesh, large),
                    Catch::StartsWith("/metric/h_min: 1 exceeds h_max, 0.35") && Catch::Contains("none is given"));
}

TEST_CASE("a case's size limits are numbers, expressions of parameters, or of x and y", "[adapt][case][limits]") {
  const auto read = [](const std::string& metric) {
    return parse_case(support::case_text(R"("interpolate": "x")", R"(, "parameters": {"a": 4}, "metric": )" + metric),
                      "case.json");
  };
  const Case constant = read(R"({"h_min": "1/a", "h_max": 2})");
  CHECK(constant.metric.h_min == 0.25);
  CHECK_FALSE(constant.metric.h_min_at);
  CHECK(constant.metric.h_max == 2.0);
  const Case varying = read(R"({"h_max": "0.1 + x/a"})");
  REQUIRE(varying.metric.h_max_at);
  CHECK(varying.metric.h_max_at->value({0.5, 0.0}) == Approx(0.225).epsilon(1e-12));
  CHECK_THAT(support::issue_text(support::case_text(R"("interpolate": "x")", R"(, "metric": {"h_min": "1/0"})")),
             Catch::Contains("/metric/h_min: must be a size"));
  CHECK_THAT(support::issue_text(support::case_text(R"("interpolate": "x")", R"(, "metric": {"h_min": -1})")),
             Catch::Contains("/metric/h_min"));
}

TEST_CASE("the loop says which limit keeps the size away, and where", "[adapt][loop][limits]") {
  Case input = support::interpolation_case("sin(6*x)*y^2", R"({"vertices": 400, "max_iterations": 6})");
  SECTION("too few") {
    input.metric.h_min_at = Expression::parse("x < 0.5 ? 0.05 : 0.3");
    const LoopResult run = adapt(input, {});
    REQUIRE_FALSE(run.summary.warnings.empty());
    CHECK_THAT(run.summary.warnings.front(),
               Catch::Contains("limits forbid it: h_min at ") && Catch::Contains(" in [0, 1] x [0, 1]"));
  }
  SECTION("too many") {
    input.metric.h_max = 0.02;
    const LoopResult run = adapt(input, {});
    REQUIRE_FALSE(run.summary.warnings.empty());
    CHECK_THAT(run.summary.warnings.front(), Catch::Contains("limits forbid it: h_max at "));
  }
}
