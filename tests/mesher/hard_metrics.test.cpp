#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/metric/background_mesh.h"
#include "tests/oracle/domain_cover.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

// Metrics that no mesh satisfies: the best valid mesh must come out all the same.
namespace {

using MetricFunction = std::function<Metric(const Point&)>;

struct HardCase {
  std::string name;
  MetricFunction metric;
};

constexpr double slant = std::numbers::pi / 6.0;

/// Distance from the line through the middle of the square at the angle.
double distance_from_line(const Point& p, double angle) {
  return std::abs((p.y - 0.5) * std::cos(angle) - (p.x - 0.5) * std::sin(angle));
}

/// Edges of 0.5 along the line, 1e6 times thinner on it, growing by 0.2 per length away from it.
MetricFunction band(double angle) {
  return [angle](const Point& p) { return Metric::from_sizes(0.5, 5e-7 + 0.2 * distance_from_line(p, angle), angle); };
}

double fraction(double x) { return x - std::floor(x); }

/// Sizes from 0.003 to 0.3 and a direction that change completely within 1e-9.
Metric noise(const Point& p) {
  const double a = fraction(1e4 * std::sin(1e5 * p.x + 3e5 * p.y));
  const double b = fraction(1e4 * std::sin(2e5 * p.x - 1e5 * p.y));
  return Metric::from_sizes(std::pow(10.0, 2.0 * a - 2.5), std::pow(10.0, 2.0 * b - 2.5), 7.0 * a);
}

Metric chessboard(const Point& p) {
  return Metric::isotropic(std::fmod(std::floor(7.0 * p.x) + std::floor(7.0 * p.y), 2.0) == 0.0 ? 0.02 : 200.0);
}

const std::vector<HardCase>& hard_cases() {
  static const std::vector<HardCase> all{
      {"jump of 1e4 across a line", [](const Point& p) { return Metric::isotropic(p.x > 0.95 ? 2.5e-3 : 25.0); }},
      {"jump of 1e4 into a strip",
       [](const Point& p) { return Metric::from_sizes(distance_from_line(p, 0.0) < 5e-5 ? 1e-5 : 0.1, 0.1, 0.0); }},
      {"jump of 1e4 in a chessboard", chessboard},
      {"jump of 1e4 in a point",
       [](const Point& p) {
         return Metric::isotropic(norm(p - Point{0.5, 0.5}) < 1e-5 ? 1e-5 : 0.1);
       }},
      {"turn by a right angle across a line",
       [](const Point& p) { return Metric::from_sizes(p.x < 0.5 ? 2e-3 : 0.5, p.x < 0.5 ? 0.5 : 2e-3, 0.0); }},
      {"aspect 1e6 along the sides", band(0.0)},
      {"aspect 1e6 at 30 degrees", band(slant)},
      {"noise", noise},
      {"much larger than the domain", [](const Point&) { return Metric::isotropic(1e6); }},
  };
  return all;
}

void check_valid(const Mesh& mesh, const Domain& domain) {
  const std::vector<std::string> none;
  CHECK_THAT(oracle::problems_of(mesh), Catch::Matchers::Equals(none));
  CHECK_THAT(oracle::problems_of_cover(mesh, domain), Catch::Matchers::Equals(none));
}

/// The square with two segments from (0.2, 0.5), 0.6 long, at an angle of so many degrees.
Domain wedge(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(),
                       {{0.2, 0.5}, {0.8, 0.5}, {0.2 + 0.6 * std::cos(angle), 0.5 + 0.6 * std::sin(angle)}});
  domain.segments.insert(domain.segments.end(), {{4, 5, 5}, {4, 6, 6}});
  return domain;
}

/// The square with two short segments in its middle.
Domain close_points(double gap) {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.5, 0.5}, {0.5 + gap, 0.5}, {0.5, 0.5 + gap}});
  domain.segments.insert(domain.segments.end(), {{4, 5, 5}, {5, 6, 6}});
  return domain;
}

/// The square with a short side at the bottom and a segment as near to it.
Domain close_to_the_side(double gap) {
  Domain domain;
  support::add_polygon(domain, {{0, 0}, {0.5, 0}, {0.5 + gap, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  domain.points.insert(domain.points.end(), {{0.2, gap}, {0.8, gap}});
  domain.segments.push_back({6, 7, 7});
  return domain;
}

/// The square cut by a slit of this half width from the top almost to the bottom.
Domain slit(double half_width) {
  Domain domain;
  support::add_polygon(domain,
                       {{0, 0}, {1, 0}, {1, 1}, {0.5 + half_width, 1}, {0.5, 0.01}, {0.5 - half_width, 1}, {0, 1}}, 1);
  return domain;
}

}  // namespace

TEST_CASE("a metric that cannot be satisfied gives a valid mesh", "[mesher][generate]") {
  const Domain domain = support::unit_square();
  const HardCase hard = GENERATE(from_range(hard_cases()));
  CAPTURE(hard.name);
  const CallableField field(hard.metric);

  SECTION("from scratch and from the mesh before") {
    const Mesh scratch = generate(domain, field).mesh;
    check_valid(scratch, domain);
    check_valid(generate(domain, field, {}, scratch).mesh, domain);
  }
  SECTION("carried by a mesh that does not resolve it") {
    // With an even number of cells, vertices on the thin line would spread its size over whole cells.
    const Mesh coarse = support::rectangle_mesh(9, 9);
    std::vector<Metric> metrics;
    for (const Point& p : coarse.points) metrics.push_back(hard.metric(p));
    check_valid(generate(domain, BackgroundMesh(coarse, metrics), {}, coarse).mesh, domain);
  }
}

TEST_CASE("constraints much nearer than the size give a valid mesh", "[mesher][generate]") {
  const Domain domain = GENERATE(wedge(0.1), wedge(1e-6), close_points(1e-6), close_points(1e-12),
                                 close_to_the_side(1e-6), close_to_the_side(1e-12), slit(1e-6));
  const double h = GENERATE(0.1, 0.03, 1e4);
  CAPTURE(domain.points.size(), domain.points.back().x, domain.points.back().y, h);
  const ConstantField field(Metric::isotropic(h));
  const Mesh scratch = generate(domain, field).mesh;
  check_valid(scratch, domain);
  check_valid(generate(domain, field, {}, scratch).mesh, domain);
}

TEST_CASE("constraints across an anisotropic metric give a valid mesh", "[mesher][generate]") {
  const Domain domain = wedge(0.1);
  const double angle = GENERATE(0.0, slant, std::numbers::pi / 2.0);
  check_valid(generate(domain, ConstantField(Metric::from_sizes(2e-3, 0.3, angle))).mesh, domain);
}

TEST_CASE("a size that is not positive is refused wherever the mesher meets it", "[mesher][generate][errors]") {
  const double bad =
      GENERATE(0.0, -0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  const double from = GENERATE(0.0, 0.5);
  const CallableField field([=](const Point& p) { return Metric::isotropic(p.x >= from ? bad : 0.1); });
  CHECK_THROWS_AS(generate(support::unit_square(), field), InputError);
}

TEST_CASE("a tensor that is not positive definite is refused wherever the mesher meets it",
          "[mesher][generate][errors]") {
  const SymmetricTensor bad = GENERATE(SymmetricTensor{100, 200, 100}, SymmetricTensor{-1, 0, 1}, SymmetricTensor{});
  const CallableField field(
      [=](const Point& p) { return p.y > 0.7 ? Metric::from_tensor(bad) : Metric::isotropic(0.1); });
  CHECK_THROWS_AS(generate(support::unit_square(), field), InputError);
}

TEST_CASE("a metric that is not finite somewhere is refused with the place, one beyond all sizes by the limit",
          "[mesher][generate][errors]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const CallableField half([nan](const Point& p) {
    return p.x < 0.5 ? Metric::isotropic(0.1) : Metric::from_log({nan, 0.0, 0.0});
  });
  CHECK_THROWS_AS(generate(support::unit_square(), half), InputError);
  const CallableField tiny([](const Point&) { return Metric::isotropic(1e-60); });
  CHECK_THROWS_AS(generate(support::unit_square(), tiny), LimitError);
  const CallableField huge([](const Point&) { return Metric::isotropic(1e100); });
  CHECK_THROWS_AS(generate(support::unit_square(), huge), InputError);  // its determinant underflows
}

TEST_CASE("a user's own field that is not finite somewhere is refused with the place", "[mesher][generate][errors]") {
  // One is met where the complexity is integrated, the other where particles are, on the boundary.
  class HoleyField final : public MetricField {
   public:
    Metric at(const Point& p, MetricHint&) const override {
      const bool in_hole = norm(p - Point{0.52, 0.51}) < 0.03;
      return in_hole ? Metric::from_log({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}) : Metric::isotropic(0.02);
    }
  };
  class FieldWithBadBoundary final : public MetricField {
   public:
    Metric at(const Point& p, MetricHint&) const override {
      return p.y == 0.0 ? Metric::from_log({800.0, 0.0, 800.0}) : Metric::isotropic(0.1);  // exp overflows
    }
  };
  CHECK_THROWS_WITH(generate(support::unit_square(), HoleyField()), Catch::Contains(") is not finite"));
  CHECK_THROWS_WITH(generate(support::unit_square(), FieldWithBadBoundary()), Catch::Contains(", 0) is not finite"));
}

TEST_CASE("particles go though every star is far from the metric", "[mesher][generate][slow]") {
  // The band of height 5e-7 is seen by chance: whatever is made for it must go when the next mesh misses it.
  const auto band = [](const Point& p) { return Metric::from_sizes(0.5, 5e-7 + 0.2 * std::abs(p.y - 0.5), 0.0); };
  Mesh mesh = generate(support::unit_square(), ConstantField(Metric::isotropic(0.1))).mesh;
  int most = 0;
  for (int i = 0; i < 4; ++i) {
    std::vector<Metric> metrics;
    for (const Point& p : mesh.points) metrics.push_back(band(p));
    mesh = generate(support::unit_square(), BackgroundMesh(mesh, metrics), {}, mesh).mesh;
    most = std::max(most, mesh.num_vertices());
  }
  CAPTURE(most);
  CHECK(mesh.num_vertices() < 5000);
}
