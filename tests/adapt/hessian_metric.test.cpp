#include "adapt/hessian_metric.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesher/errors.h"
#include "mesher/metric/gradation.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Smooth Hessians of all signs, with eigenvalues away from 0.
std::vector<AbsoluteHessian> some_hessians(const Mesh& mesh, double factor = 1.0, double turn = 0.0) {
  std::vector<AbsoluteHessian> hessians;
  for (const Point& p : mesh.points) {
    const double angle = 2.0 * p.x + p.y + turn;
    const Eigen2 e{factor * (3.0 + p.x), factor * (0.5 + p.y), {std::cos(angle), std::sin(angle)}};
    hessians.push_back({compose(e), p.x < 0.5 ? 1.0 : 0.0});
  }
  return hessians;
}

MetricRequest wide_open(double complexity) {
  MetricRequest request;
  request.options.h_max = 1e6;
  request.complexity = complexity;
  return request;
}

double size_along(const Metric& m, double angle) { return 1.0 / m.length({std::cos(angle), std::sin(angle)}); }

double aspect(const Metric& m) {
  const Eigen2 e = eigen_decomposition(m.tensor());
  return std::sqrt(std::max(e.l1, e.l2) / std::min(e.l1, e.l2));
}

/// Squared L2 error per area of the interpolant of (h0 x^2 + h1 y^2)/2 on triangles equilateral in m, their mean over
/// the angles, by the midpoint rule on n^2 parts.
double squared_error_of_unit_mesh(const std::array<double, 2>& h, const SymmetricTensor& m) {
  constexpr int angles = 12, n = 16;
  const double sx = 1.0 / std::sqrt(m.xx), sy = 1.0 / std::sqrt(m.yy);
  const auto u = [&](const Point& p) { return 0.5 * (h[0] * p.x * p.x + h[1] * p.y * p.y); };
  double sum = 0.0;
  for (int k = 0; k < angles; ++k) {
    std::array<Point, 3> c;
    for (int i = 0; i < 3; ++i) {
      const double turn = 2.0 * std::numbers::pi * (i / 3.0 + k / (3.0 * angles));
      c[static_cast<std::size_t>(i)] = {sx * std::cos(turn) / std::numbers::sqrt3,
                                        sy * std::sin(turn) / std::numbers::sqrt3};
    }
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        double s = (i + 0.5) / n, t = (j + 0.5) / n;
        if (s + t > 1.0) s = 1.0 - s, t = 1.0 - t;
        const double r = 1.0 - s - t;
        const Point p{r * c[0].x + s * c[1].x + t * c[2].x, r * c[0].y + s * c[1].y + t * c[2].y};
        const double e = u(p) - (r * u(c[0]) + s * u(c[1]) + t * u(c[2]));
        sum += e * e;
      }
    }
  }
  return sum / (angles * n * n);
}

}  // namespace

TEST_CASE("complexity of a constant metric is its density times the area", "[adapt][metric]") {
  const Mesh mesh = support::random_square(6, 0.2, 1);
  const std::vector<Metric> metrics(mesh.points.size(), Metric::from_sizes(0.1, 0.02, 0.3));
  CHECK(complexity(mesh, metrics) == Approx(1.0 / (0.1 * 0.02)).epsilon(1e-12));
  CHECK_THROWS_AS(complexity(mesh, std::vector<Metric>(2)), InputError);
}

TEST_CASE("complexity integrates a density that grows exponentially", "[adapt][metric]") {
  // h = e^(-x): sqrt(det M) = e^(2x), its integral over the unit square (e^2 - 1) / 2; degree 3 on 1/8.
  const Mesh mesh = support::rectangle_mesh(8, 2);
  std::vector<Metric> metrics;
  for (const Point& p : mesh.points) metrics.push_back(Metric::isotropic(std::exp(-p.x)));
  CHECK(complexity(mesh, metrics) == Approx((std::exp(2.0) - 1.0) / 2.0).epsilon(1e-5));
}

TEST_CASE("the complexity asked for is reached where no limit binds", "[adapt][metric]") {
  const Mesh mesh = support::random_square(10, 0.2, 4);
  const double norm = GENERATE(1.0, 2.0, 4.0, infinity);
  const double wanted = GENERATE(10.0, 1e5);
  MetricRequest request = wide_open(wanted);
  request.options.norm = norm;
  const HessianMetric metric = metric_from_hessians(mesh, some_hessians(mesh), request);
  CHECK(metric.complexity == Approx(wanted).epsilon(1e-6));
  CHECK(complexity(mesh, metric.metrics) == Approx(wanted).epsilon(1e-6));
  CHECK(metric.clipped.h_max.count + metric.clipped.h_min.count + metric.clipped.aspect.count == 0);
}

TEST_CASE("the metric does not depend on the unit of the function", "[adapt][metric]") {
  const Mesh mesh = support::rectangle_mesh(6, 6);
  const HessianMetric a = metric_from_hessians(mesh, some_hessians(mesh), wide_open(500));
  const HessianMetric b = metric_from_hessians(mesh, some_hessians(mesh, 1e-7), wide_open(500));
  for (std::size_t v = 0; v < a.metrics.size(); ++v)
    CHECK(a.metrics[v].density() == Approx(b.metrics[v].density()).epsilon(1e-6));
}

TEST_CASE("turning the Hessians turns the metric", "[adapt][metric]") {
  const Mesh mesh = support::rectangle_mesh(6, 6);
  const double turn = 0.7;
  const HessianMetric a = metric_from_hessians(mesh, some_hessians(mesh), wide_open(500));
  const HessianMetric b = metric_from_hessians(mesh, some_hessians(mesh, 1.0, turn), wide_open(500));
  for (std::size_t v = 0; v < a.metrics.size(); v += 5)
    for (const double angle : {0.0, 0.4, 1.3})
      CHECK(size_along(a.metrics[v], angle) == Approx(size_along(b.metrics[v], angle + turn)).epsilon(1e-6));
}

TEST_CASE("the density of the Lp metric is |det H|^(p / (2p + 2))", "[adapt][metric]") {
  // Two Hessians whose determinants differ by 256: 256^(1/4), 256^(1/3), 256^(1/2).
  MetricRequest request = wide_open(1.0);
  const auto [norm, expected] = GENERATE(table<double, double>({{1.0, 4.0}, {2.0, 6.349604}, {infinity, 16.0}}));
  request.options.norm = norm;
  const SymmetricTensor small = scale_for_error({{2, 0, 0.5}, 0.0}, 0.0, request);
  const SymmetricTensor large = scale_for_error({{32, 0, 8}, 0.0}, 0.0, request);
  CHECK(std::sqrt(determinant(large) / determinant(small)) == Approx(expected).epsilon(1e-5));
  CHECK(large.xx / large.yy == Approx(4.0).epsilon(1e-12));  // the shape stays that of |H|
}

TEST_CASE("the H1 metric has the density tr^(1/2) det^(1/4)", "[adapt][metric]") {
  MetricRequest request = wide_open(1.0);
  request.measure = ErrorMeasure::H1;
  // tr = 5, det = 4: sqrt 5 * sqrt 2 = sqrt 10.
  const SymmetricTensor m = scale_for_error({{4, 0, 1}, 0.0}, 0.0, request);
  CHECK(std::sqrt(determinant(m)) == Approx(std::sqrt(10.0)).epsilon(1e-12));
  const SymmetricTensor saddle = scale_for_error({{4, 0, 1}, 1.0}, 0.0, request);
  CHECK(saddle.xx / m.xx == Approx(std::numbers::sqrt2).epsilon(1e-12));
}

TEST_CASE("sign-aware metrics are coarser where det H < 0, Loseille-Alauzet's are not", "[adapt][metric]") {
  MetricRequest request = wide_open(1.0);
  const AbsoluteHessian saddle{{3, 1, 2}, 1.0};
  const AbsoluteHessian bowl{{3, 1, 2}, 0.0};
  const auto ratio = [&] { return scale_for_error(saddle, 0.0, request).xx / scale_for_error(bowl, 0.0, request).xx; };
  SECTION("p = 2: halved") { CHECK(ratio() == Approx(0.5).epsilon(1e-14)); }
  SECTION("p = infinity: 0.75") {
    request.options.norm = infinity;
    CHECK(ratio() == Approx(0.75).epsilon(1e-14));
  }
  SECTION("Loseille-Alauzet") {
    request.options.kind = MetricKind::LoseilleAlauzet;
    CHECK(ratio() == 1.0);
  }
  SECTION("a patch of both signs lies in between") {
    const AbsoluteHessian mixed{{3, 1, 2}, 0.5};
    const double share = scale_for_error(mixed, 0.0, request).xx / scale_for_error(bowl, 0.0, request).xx;
    CHECK(share == Approx(std::numbers::sqrt2 / 2.0).epsilon(1e-14));
  }
}

TEST_CASE("sign_factor has the known values and no jumps between them", "[adapt][metric]") {
  CHECK(sign_factor(1.0) == Approx(0.547).epsilon(1e-12));
  CHECK(sign_factor(2.0) == Approx(0.5).epsilon(1e-14));
  CHECK(sign_factor(4.0) == Approx(0.509).epsilon(1e-12));
  CHECK(sign_factor(infinity) == 0.75);
  CHECK(sign_factor(3.0) > 0.5);
  CHECK(sign_factor(3.0) < 0.509);
}

TEST_CASE("where max_aspect binds the density is that of the shapes it leaves", "[adapt][metric]") {
  // Eigenvalues 1 and 1e-6 and those of aspect 4, 1 and 1/16: the metric sees the same triangles, but for the sign.
  MetricRequest request = wide_open(1.0);
  request.options.max_aspect = 4.0;
  request.measure = GENERATE(ErrorMeasure::Lp, ErrorMeasure::H1);
  request.options.kind = MetricKind::LoseilleAlauzet;
  const SymmetricTensor thin = scale_for_error({{1, 0, 1e-6}, 0.0}, 0.0, request);
  const SymmetricTensor bound = scale_for_error({{1, 0, 1.0 / 16}, 0.0}, 0.0, request);
  CHECK(thin.xx == Approx(bound.xx).epsilon(1e-12));
  CHECK(thin.yy < bound.yy);  // left to the limits, which report it
}

TEST_CASE("no other sharing of triangles between two functions has a smaller L2 error", "[adapt][metric]") {
  // u'' = (a, b) on two squares, triangles equilateral in the metric scale_for_error gives with aspect 2 at most. Their
  // errors by quadrature; moving 10 % of the density from one square to the other must not lower the sum of squares.
  MetricRequest request = wide_open(1.0);
  request.options.max_aspect = 2.0;
  using Eigenvalues = std::array<double, 2>;
  using Pair = std::array<Eigenvalues, 2>;
  const Pair pair = GENERATE(Pair{{{1.0, 1.0}, {1.0, 1e-4}}}, Pair{{{1.0, -1.0}, {1.0, 1e-4}}},
                             Pair{{{1.0, 0.1}, {1.0, -0.1}}}, Pair{{{3.0, -0.5}, {1.0, 0.01}}});
  const auto optimal = [&](const Eigenvalues& h) {
    const AbsoluteHessian hessian{{h[0], 0, std::abs(h[1])}, h[1] < 0.0 ? 1.0 : 0.0};
    SymmetricTensor m = scale_for_error(hessian, 0.0, request);
    m.yy = std::max(m.yy, 0.25 * m.xx);
    return m;
  };
  const SymmetricTensor ma = optimal(pair[0]), mb = optimal(pair[1]);
  const double da = std::sqrt(ma.xx * ma.yy), db = std::sqrt(mb.xx * mb.yy);
  const auto total = [&](double moved) {
    const auto part = [](const Eigenvalues& h, const SymmetricTensor& m, double factor) {
      return squared_error_of_unit_mesh(h, factor * m);
    };
    return part(pair[0], ma, 1.0 + moved / da) + part(pair[1], mb, 1.0 - moved / db);
  };
  const double step = 0.1 * std::min(da, db);
  CHECK(total(0.0) <= total(step));
  CHECK(total(0.0) <= total(-step));
}

TEST_CASE("limits hold in every metric and win over the complexity", "[adapt][metric]") {
  const Mesh mesh = support::random_square(8, 0.2, 9);
  MetricRequest request;
  request.options.h_min = 0.05;
  request.options.h_max = 0.2;
  request.options.max_aspect = 1.5;
  request.complexity = GENERATE(1.0, 150.0, 1e7);
  const HessianMetric metric = metric_from_hessians(mesh, some_hessians(mesh), request);
  for (const Metric& m : metric.metrics) {
    CHECK(aspect(m) <= 1.5 * (1.0 + 1e-9));
    for (int k = 0; k < 16; ++k) {
      CHECK(size_along(m, 0.2 * k) >= 0.05 * (1.0 - 1e-9));
      CHECK(size_along(m, 0.2 * k) <= 0.2 * (1.0 + 1e-9));
    }
  }
  if (request.complexity == 1.0) CHECK(metric.complexity == Approx(1.0 / 0.04).epsilon(1e-6));
  if (request.complexity == 150.0) CHECK(metric.complexity == Approx(150.0).epsilon(1e-6));
  if (request.complexity == 1e7) CHECK(metric.complexity == Approx(1.0 / 0.0025).epsilon(1e-6));
  if (request.complexity != 150.0)
    CHECK(metric.clipped.h_max.count + metric.clipped.h_min.count == mesh.num_vertices());
}

TEST_CASE("the complexity is reached after the gradation", "[adapt][metric]") {
  const Mesh mesh = support::rectangle_mesh(30, 30);
  const auto hessians = exact_absolute_hessians(mesh, Expression::parse("tanh(20*(x - y^2))"));
  MetricRequest request = wide_open(2000.0);
  request.options.gradation = 1.5;
  const HessianMetric metric = metric_from_hessians(mesh, hessians, request);
  CHECK(metric.clipped.gradation.count > 0);
  CHECK(metric.complexity == Approx(2000.0).epsilon(1e-3));
  CHECK(limit_gradation(mesh, metric.metrics, 1.5 * (1.0 + 1e-4)) == metric.metrics);
}

TEST_CASE("isotropic metrics follow the largest eigenvalue alone", "[adapt][metric]") {
  const Mesh mesh = support::rectangle_mesh(5, 5);
  MetricRequest request = wide_open(300.0);
  request.isotropic = true;
  for (const Metric& m : metric_from_hessians(mesh, some_hessians(mesh), request).metrics)
    CHECK(aspect(m) == Approx(1.0).epsilon(1e-9));
  // p = 2: s = lambda^(2/3), whatever the other eigenvalue is.
  const double a = scale_for_error({{8, 0, 0.01}, 0.0}, 0.0, request).yy;
  const double b = scale_for_error({{1, 0, 0.5}, 1.0}, 0.0, request).yy;
  CHECK(a / b == Approx(4.0).epsilon(1e-12));
}

TEST_CASE("the floor takes 2 % of the complexity where the Hessian vanishes", "[adapt][metric]") {
  // |H| = I on the left half, 0 on the right one: density 1 against floor^(2/3) for p = 2.
  const Mesh mesh = support::rectangle_mesh(40, 2);
  std::vector<AbsoluteHessian> hessians;
  for (const Point& p : mesh.points)
    hessians.push_back({p.x < 0.5 ? SymmetricTensor{1, 0, 1} : SymmetricTensor{}, 0.0});
  const double floor = eigenvalue_floor(mesh, hessians, wide_open(1.0));
  CHECK(std::pow(floor, 2.0 / 3.0) == Approx(0.02 * 0.5).epsilon(0.05));
}

TEST_CASE("a layer 1e-4 thin does not raise the floor of the rest", "[adapt][metric]") {
  // |H| = (1e8, 1) in the first of 1000 columns: density 1e8^(1/3) on 1/2000 of the area, by the vertices.
  const Mesh mesh = support::rectangle_mesh(1000, 1);
  std::vector<AbsoluteHessian> hessians;
  for (const Point& p : mesh.points)
    hessians.push_back({p.x == 0.0 ? SymmetricTensor{1e8, 0, 1} : SymmetricTensor{}, 0.0});
  const double floor = eigenvalue_floor(mesh, hessians, wide_open(1.0));
  CHECK(std::pow(floor, 2.0 / 3.0) == Approx(0.02 * std::cbrt(1e8) / 2000).epsilon(0.05));
}

TEST_CASE("flat functions and functions of one variable have finite metrics", "[adapt][metric]") {
  const Mesh mesh = support::rectangle_mesh(10, 10);
  const std::string text = GENERATE("0", "x + y", "x^2", "tanh(30*(x - 0.5))");
  const auto hessians = exact_absolute_hessians(mesh, Expression::parse(text));
  MetricRequest request;
  request.complexity = 1000.0;
  const HessianMetric metric = metric_from_hessians(mesh, hessians, request);
  CHECK(metric.floor > 0.0);
  CHECK(metric.complexity == Approx(1000.0).epsilon(1e-5));
}

TEST_CASE("h_max defaults to a quarter of the domain's diagonal", "[adapt][metric]") {
  const Mesh mesh = support::rectangle_mesh(4, 4, {0, 0}, {3, 4});
  MetricRequest request;
  request.complexity = 1e-3;
  for (const Metric& m : metric_from_hessians(mesh, some_hessians(mesh), request).metrics)
    CHECK(size_along(m, 0.0) == Approx(1.25).epsilon(1e-9));
}

TEST_CASE("limits that contradict each other are refused", "[adapt][metric][errors]") {
  const Mesh mesh = support::rectangle_mesh(2, 2);
  MetricRequest request;
  request.options.h_min = 2.0;
  request.options.h_max = 1.0;
  CHECK_THROWS_AS(metric_from_hessians(mesh, some_hessians(mesh), request), InputError);
  request = {};
  request.options.max_aspect = 0.5;
  CHECK_THROWS_AS(metric_from_hessians(mesh, some_hessians(mesh), request), InputError);
  CHECK_THROWS_AS(metric_from_hessians(mesh, {}, MetricRequest{}), InputError);
}
