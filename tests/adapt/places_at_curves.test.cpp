#include "adapt/places_at_curves.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>

#include "adapt/functional_value.h"
#include "adapt/iterate.h"
#include "tests/adapt/case_support.h"

using namespace parmesan;

namespace {

std::string place_text(const Point& p, int digits) {
  std::ostringstream out;
  out << std::setprecision(digits) << "[" << p.x << ", " << p.y << "]";
  return out.str();
}

/// What the case's first functional is for the function 2 x + 3 y on a mesh of about so many vertices.
double value_of_plane(const Case& input, double vertices) {
  Iterate iterate = uniform_iterate(input, vertices);
  compute_values(input, iterate, nullptr);
  return evaluate(input.functionals.front(), iterate.mesh, iterate.values, {});
}

std::string plane_case(const std::string& geometry, const std::string& place) {
  return R"({"geometry": {)" + geometry +
         R"(}, "problem": {"interpolate": "2*x + 3*y"}, "functionals": {"here": {"value": )" + place + "}}}";
}

}  // namespace

TEST_CASE("values are known on curves and between them and their chords", "[adapt][curves]") {
  const std::string ring =
      R"("disc": {"center": [3, -1], "radius": 2}, "holes": [{"disc": {"center": [3.5, -1], "radius": 1}}])";
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angles(-4.0, 4.0);
  for (int k = 0; k < 20; ++k) {
    const double angle = angles(random);
    const Vector u{std::cos(angle), std::sin(angle)};
    const Point outer = Point{3.0, -1.0} + 2.0 * u;
    const Point inner = Point{3.5, -1.0} + 1.0 * u;
    const Point almost = Point{3.0, -1.0} + 1.9999 * u;
    const int digits = k % 2 == 0 ? 17 : 7;
    for (const Point& place : {outer, inner, almost}) {
      INFO(place_text(place, digits));
      const Case input = parse_case(plane_case(ring, place_text(place, digits)), "case.json");
      CHECK(value_of_plane(input, 150.0) == Approx(2 * place.x + 3 * place.y).margin(1e-5));
    }
  }
}

TEST_CASE("places at the ends of curves are those of the domain", "[adapt][curves]") {
  const std::string half = R"("polygon": [[0, 0], [1, 0], [0, 1]])";
  const std::string disc = R"("disc": {"radius": 1}, "points": [[0, 1]])";
  for (const Point& place : {Point{1e-9, 1.0}, Point{0.0, 1.0}, Point{-3e-8, 1.0 - 1e-8}}) {
    const Case input = parse_case(plane_case(disc, place_text(place, 17)), "case.json");
    CHECK(input.functionals.front().point == Point{0.0, 1.0});
    CHECK(input.domain.points.size() == parse_case(plane_case(disc, "[0, 0]"), "case.json").domain.points.size());
  }
  // No more points where there are no curves, or where they are far.
  CHECK(parse_case(plane_case(half, "[0.5, 0.5]"), "case.json").domain.points.size() == 3);
}

TEST_CASE("places outside of curves are refused as before", "[adapt][curves][errors]") {
  const std::string disc = R"("disc": {"radius": 1})";
  const Case input = parse_case(plane_case(disc, "[0.6, 0.8005]"), "case.json");
  CHECK_THROWS_WITH(value_of_plane(input, 100.0), Catch::Contains("the point lies outside of the domain"));
}
