#include "adapt/case_shapes.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <sstream>

#include "adapt/case.h"
#include "case_support.h"
#include "mesher/delaunay_mesh.h"
#include "mesher/errors.h"
#include "tests/oracle/mesh_checker.h"

namespace parmesan {
namespace {

using support::domain_of_case;
using support::issues_of_geometry;

double area(const Domain& domain) { return oracle::area_of(delaunay_mesh(domain).mesh); }

std::set<std::string> names(const Domain& domain) {
  std::set<std::string> found;
  for (const Segment& s : domain.segments) found.insert(label_name(domain.label_names, s.label));
  return found;
}

std::string box(double x0, double y0, double x1, double y1, const std::string& rest = "") {
  std::ostringstream text;
  text << R"({"rectangle": {"min": [)" << x0 << ", " << y0 << R"(], "max": [)" << x1 << ", " << y1 << "]}" << rest
       << "}";
  return text.str();
}

}  // namespace

TEST_CASE("Shapes are joined, cut and taken away; each names its sides", "[adapt][case]") {
  const std::string notch = box(1, 1, 3, 3, R"(, "labels": {"left": "notch", "bottom": "notch"})");
  const Domain rest = domain_of_case(R"("difference": [)" + box(0, 0, 2, 2) + ", " + notch + "]");
  CHECK(area(rest) == Approx(3.0).epsilon(1e-15));
  CHECK(names(rest) == std::set<std::string>{"left", "right", "bottom", "top", "notch"});
  const Domain joined = domain_of_case(R"("union": [)" + box(0, 0, 2, 2) + ", " + box(2, 0, 3, 2) + "]");
  CHECK(joined.segments.size() == 6);
  const Domain common = domain_of_case(R"("intersection": [)" + box(0, 0, 2, 2) + ", " + notch +
                                       R"(, {"polygon": [[0, 0], [4, 0], [0, 4]], "labels": ["a", "slope", "b"]}],
                                       "labels": {"notch": "n"})");
  CHECK(area(common) == 1.0);  // the slope touches the corner (2, 2) only
  CHECK(names(common) == std::set<std::string>{"n", "right", "top"});
}

TEST_CASE("Operations nest, and what is put inside works on the result", "[adapt][case]") {
  const Domain domain = domain_of_case(R"(
      "difference": [{"union": [)" + box(0, 0, 4, 2) +
                                       ", " + box(0, 0, 2, 4) + R"(], "labels": {"top": "roof"}},
                     {"disc": {"center": [1, 1], "radius": 0.5}, "labels": {"circle": "pipe"}},
                     {"naca": {"code": "0012", "position": [2.2, 1], "chord": 1.5}}],
      "regions": {"steel": [3.9, 0.1]}, "points": [[0.25, 3]], "segments": [{"from": [0, 2], "to": [2, 2], "label": "weld"}])");
  CHECK(names(domain) == std::set<std::string>{"left", "right", "bottom", "roof", "pipe", "airfoil", "weld"});
  CHECK(domain.holes.size() == 2);
  REQUIRE(domain.regions.size() == 1);
  CHECK(label_name(domain.region_names, domain.regions[0].region) == "steel");
  CHECK(std::count(domain.points.begin(), domain.points.end(), Point{0.25, 3}) == 1);
}

TEST_CASE("Discs stay true circles where shapes are made of them", "[adapt][case]") {
  const Domain eye =
      domain_of_case(R"("intersection": [{"disc": {"radius": 1}}, {"disc": {"center": [1, 0], "radius": 1}}])");
  for (const Segment& s : eye.segments) CHECK_FALSE(s.is_straight());
  CHECK(std::any_of(eye.points.begin(), eye.points.end(), [](const Point& p) {
    return norm(p - Point{0.5, std::sqrt(0.75)}) < 1e-15;
  }));
}

TEST_CASE("What is wrong with a shape is said at its place", "[adapt][case][errors]") {
  CHECK(issues_of_geometry(R"("intersection": [)" + box(0, 0, 1, 1) + ", " + box(1, 0, 2, 1) + "]") ==
        "/geometry/intersection: leaves nothing: the result has no area\n");
  CHECK(issues_of_geometry(R"("union": [)" + box(0, 0, 1, 1) + "]") ==
        "/geometry/union: must be a list of at least 2 shapes, not a list of 1\n");
  CHECK_THAT(issues_of_geometry(R"("union": [)" + box(0, 0, 1, 1) + R"(, {"union": [{"disk": {"radius": 1}}, )" +
                                box(0, 0, 1, 1) + "]}]"),
             Catch::Contains("/geometry/union/1/union/0/disk: unknown key 'disk'; did you mean 'disc'?"));
  CHECK_THAT(issues_of_geometry(R"("union": [)" + box(0, 0, 1, 1) + ", " + box(0, 0, -1, 1) + "]"),
             Catch::Contains("/geometry/union/1/rectangle: 'min' must be smaller"));
  CHECK_THAT(issues_of_geometry(R"("union": [)" + box(0, 0, 1, 1) + ", " +
                                box(0, 0, 2, 1, R"(, "labels": {"lft": "a"})") + "]"),
             Catch::Contains("/geometry/union/1/labels/lft: there is no side 'lft'"));
  CHECK_THAT(
      issues_of_geometry(R"("union": [)" + box(0, 0, 1, 1) + R"(, {"disc": {"radius": 1}, "points": [[0, 0]]}])"),
      Catch::Contains("/geometry/union/1/points: unknown key"));
  CHECK_THAT(issues_of_geometry(R"("naca": {"code": "0012"})"),
             Catch::Contains("/geometry/naca: the key 'channel' is missing"));
  CHECK_THROWS_WITH(domain_of_case(R"("union": [)" + box(0, 0, 1, 1) + R"(, {"polygon": [[0,0],[1,1],[1,0],[0,1]]}])"),
                    Catch::Contains("/geometry/union/1: segments 0 and 2 cross"));
}

}  // namespace parmesan
