#include "adapt/case_curves.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "adapt/case.h"
#include "case_support.h"
#include "mesher/errors.h"
#include "mesher/geometry/segment_path.h"

namespace parmesan {
namespace {

using support::domain_of_case;
using support::issue_text;
using support::issues_of_geometry;

/// The area that the segments with this label sweep about the origin, by the midpoint rule on each.
double swept_area(const Domain& domain, const std::string& label) {
  constexpr int parts = 2000;
  double area = 0.0;
  for (const Segment& s : domain.segments) {
    if (label_name(domain.label_names, s.label) != label) continue;
    for (int i = 0; i < parts; ++i)
      area += 0.5 * cross(point_on(domain, s, static_cast<double>(i) / parts), point_on(domain, s, (i + 1.0) / parts));
  }
  return area;
}

std::string with_piece(const std::string& piece) {
  return R"j("curves": [{"line": [[0, 0], [1, 0]]}, )j" + piece + R"j(, {"line": [[1, 1], [0, 1], [0, 0]]}])j";
}

}  // namespace

TEST_CASE("A disc is the true circle unless it has points", "[adapt][case]") {
  const Domain domain = domain_of_case(R"j("disc": {"center": [1, -1], "radius": "r"})j");
  REQUIRE(domain.segments.size() == 1);
  CHECK_FALSE(domain.segments[0].is_straight());
  CHECK(swept_area(domain, "circle") == Approx(4.0 * M_PI).epsilon(1e-5));
  for (double t = 0.0; t <= 1.0; t += 0.1)
    CHECK(norm(point_on(domain, domain.segments[0], t) - Point{1.0, -1.0}) == Approx(2.0).epsilon(1e-15));
  CHECK(domain_of_case(R"j("disc": {"radius": 1, "points": 7})j").segments.size() == 7);
}

TEST_CASE("Ellipses, and holes along curves", "[adapt][case]") {
  const Domain domain = domain_of_case(R"j("ellipse": {"center": [1, 2], "axes": [5, 4], "rotation": 30},
      "holes": [{"disc": {"center": [1, 3], "radius": 0.5}, "label": "pipe"},
                {"ellipse": {"center": [1, 0], "axes": [2, 0.01], "rotation": -20}},
                {"curves": [{"arc": {"center": [3, 3], "radius": 1, "from": 0, "to": 180}},
                            {"arc": {"center": [3, 3.5], "radius": "sqrt(1.25)", "from": "180 + atan(0.5)*180/pi",
                                     "to": "360 - atan(0.5)*180/pi"}, "label": "belly"}]}])j");
  CHECK(swept_area(domain, "ellipse") == Approx(20.0 * M_PI).epsilon(1e-5));
  CHECK(swept_area(domain, "pipe") == Approx(0.25 * M_PI).epsilon(1e-5));
  CHECK(swept_area(domain, "hole2") == Approx(0.02 * M_PI).epsilon(1e-5));
  REQUIRE(domain.holes.size() == 3);
  CHECK(norm(domain.holes[0] - Point{1.0, 3.0}) < 0.5);
  CHECK(norm(domain.holes[2] - Point{3.0, 3.0}) < 1.0);
  CHECK(swept_area(domain, "hole3") + swept_area(domain, "belly") > 1.0);
}

TEST_CASE("A path of lines and curves closes; pieces have labels", "[adapt][case]") {
  const Domain domain = domain_of_case(R"j("curves": [
      {"line": [[0, 0], [3, 0]], "label": "bottom"},
      {"arc": {"center": [3, 1], "radius": 1, "from": -90, "to": 90}, "label": "nose"},
      {"spline": {"points": [[3, 2], [2, 3], [1, 1], [0, 2]]}, "label": "roof"},
      {"parametric": {"x": "-0.25*sin(pi*t)", "y": "2*(1 - t)"}}],
      "segments": [{"from": [0.5, 0.5], "to": [1, 0.5]}, {"arc": {"center": [2, 1], "radius": 0.25, "from": 0, "to": 90},
                    "label": "hook"}])j");
  REQUIRE(domain.segments.size() == 6);
  CHECK(domain.segments[0].is_straight());
  CHECK(label_name(domain.label_names, domain.segments[3].label) == "boundary");
  CHECK(label_name(domain.label_names, domain.segments[5].label) == "hook");
  for (std::size_t i = 0; i < 4; ++i) CHECK(domain.segments[i].b == domain.segments[(i + 1) % 4].a);
  // The corners of lines are as given.
  CHECK(domain.points[0] == Point{0.0, 0.0});
  CHECK(domain.points[1] == Point{3.0, 0.0});
  CHECK(swept_area(domain, "nose") + swept_area(domain, "bottom") ==
        Approx(0.5 * M_PI + 0.5 * (3.0 * 2.0)).epsilon(1e-5));  // about the origin
}

TEST_CASE("Cubic splines go through their points, open as a piece or closed alone", "[adapt][case]") {
  const Domain closed = domain_of_case(
      R"j("curves": [{"through": {"points": [[2, 0], [0, 2], [-2, 0], [0, -2]], "closed": true}, "label": "blob"}])j");
  REQUIRE(closed.segments.size() == 1);
  for (const Point& p : {Point{2, 0}, Point{0, 2}, Point{-2, 0}, Point{0, -2}})
    CHECK(norm(point_on(closed, closed.segments[0], parameter_on(closed, closed.segments[0], p)) - p) < 1e-12);
  // Of y = 2 cos: -3 y are the second derivatives by the number of the point, (2 + 0)/2 + 3 (2 + 0)/16 the middle.
  CHECK(norm(point_on(closed, closed.segments[0], 0.125) - Point{1.375, 1.375}) < 1e-14);
  const Domain open = domain_of_case(with_piece(R"j({"through": {"points": [[1, 0], [1.5, 0.5], [1, 1]]}})j"));
  CHECK_FALSE(open.segments[1].is_straight());
  CHECK_THAT(issues_of_geometry(with_piece(R"j({"through": {"points": [[1, 0], [1, 0], [1, 1]]}})j")),
             Catch::Contains("/geometry/curves/1/through/points: must differ from one to the next, but 0 and 1"));
  CHECK_THAT(issues_of_geometry(with_piece(R"j({"through": {"points": [[1, 0]]}})j")),
             Catch::Contains("/geometry/curves/1/through/points: must be at least 2, not 1"));
}

TEST_CASE("What is wrong with a curve is said at its place", "[adapt][case][errors]") {
  CHECK_THAT(issues_of_geometry(with_piece(R"j({"arc": {"center": [1, 0.5], "radius": 0.4, "from": -90, "to": 90}})j")),
             Catch::Contains("/geometry/curves/1: begins at (1, 0.1), but the piece before it ends at (1, 0)\n") &&
                 Catch::Contains("/geometry/curves/2: begins at (1, 1), but the piece before it ends at (1, 0.9)\n"));
  CHECK(issues_of_geometry(with_piece(R"j({"arc": {"radius": 0, "from": -90, "to": 90}})j")) ==
        "/geometry/curves/1/arc/radius: must be a number or an expression of the parameters above 0, not 0\n");
  CHECK_THAT(issues_of_geometry(with_piece(R"j({"ellipse": {"axes": [1, -2]}})j")),
             Catch::Contains("/geometry/curves/1/ellipse/axes/1: "));
  CHECK_THAT(issues_of_geometry(with_piece(R"j({"spline": {"points": [[1, 0], [2, 2], [1, 1]]}})j")),
             Catch::Contains("/geometry/curves/1/spline/points: must be more than the degree, 3"));
  CHECK_THAT(issues_of_geometry(with_piece(
                 R"j({"spline": {"points": [[1, 0], [2, 2], [1, 1]], "degree": 2, "knots": [0, 0, 1, 1]}})j")),
             Catch::Contains("/geometry/curves/1/spline/knots: must be 6 numbers"));
  CHECK_THAT(issues_of_geometry(with_piece(
                 R"j({"spline": {"points": [[1, 0], [2, 2], [1, 1]], "degree": 2, "knots": [0, 0, 0, 1, 1, 0.5]}})j")),
             Catch::Contains("/geometry/curves/1/spline/knots: must not fall"));
  CHECK_THAT(issues_of_geometry(with_piece(
                 R"j({"spline": {"points": [[1, 0], [2, 2], [1, 1]], "degree": 2, "weights": [1, -1, 1]}})j")),
             Catch::Contains("/geometry/curves/1/spline/weights: must be positive"));
  CHECK_THAT(issues_of_geometry(with_piece(R"j({"spline": {"points": [[1, 0], [1, 1]], "degree": 0}})j")),
             Catch::Contains("/geometry/curves/1/spline/degree: "));
  CHECK_THAT(issues_of_geometry(with_piece(R"j({"parametric": {"x": "1 + sin(pi*s)", "y": "t"}})j")),
             Catch::Contains("/geometry/curves/1/parametric/x: unknown name 's'") && Catch::Contains("'t'"));
  CHECK_THAT(issues_of_geometry(with_piece(R"j({"parametric": {"x": "1 + log(abs(t - 0.5))", "y": "t"}})j")),
             Catch::Contains("/geometry/curves/1/parametric: the curve is not finite at parameter 0.5"));
  CHECK_THAT(issues_of_geometry(with_piece(R"j({"parametric": {"x": 1, "y": 2}})j")),
             Catch::Contains("/geometry/curves/1/parametric: a curve stays in one place"));
  CHECK_THAT(
      issues_of_geometry(with_piece(R"j({"arc": {"radius": 1, "from": 0, "to": 90}, "line": [[1, 0], [1, 1]]})j")),
      Catch::Contains("give exactly one of"));
  CHECK_THAT(issues_of_geometry(R"j("curves": [])j"), Catch::Contains("/geometry/curves: must be a list of pieces"));
  CHECK_THAT(issues_of_geometry(R"j("disc": {"radius": 1}, "segments": [{"from": [0, 0]}])j"),
             Catch::Contains("/geometry/segments/0: the key 'to' is missing"));
  const std::string bow = R"j("arc": {"radius": 0.5, "from": 0, "to": 90}, "label": "bow")j";
  CHECK_THAT(issues_of_geometry(R"j("disc": {"radius": 1}, "segments": [{)j" + bow + R"j(, "required": true}])j"),
             Catch::Contains("/geometry/segments/0/required: is for straight segments"));
  CHECK_THROWS_AS(domain_of_case(with_piece(R"j({"parametric": {"x": "1 - 2*sin(pi*t)", "y": "t"}})j")), GeometryError);
}

TEST_CASE("The chord error is an option of the mesher", "[adapt][case]") {
  const std::string text =
      R"j({"geometry": {"disc": {"radius": 1}}, "problem": {"interpolate": "x"}, "mesher": {"chord_error": 0.002}})j";
  CHECK(parse_case(text, "case.json").mesher.chord_error == 0.002);
  CHECK_THAT(
      issue_text(
          R"j({"geometry": {"disc": {"radius": 1}}, "problem": {"interpolate": "x"}, "mesher": {"chord_error": 0}})j"),
      Catch::Contains("/mesher/chord_error: must be"));
}

TEST_CASE("Data on a curve are compared with the exact solution on the curve, not on chords", "[adapt][case]") {
  const auto text = [](const std::string& data) {
    return R"j({"geometry": {"disc": {"radius": 1}}, "problem": {"exact": "1 - x^2 - y^2",
               "boundary": {"circle": {"dirichlet": )j" +
           data + "}}}}";
  };
  CHECK(issue_text(text("0")).empty());
  CHECK_THAT(issue_text(text("0.1")), Catch::Contains("does not agree with 'exact'"));
}

}  // namespace parmesan
