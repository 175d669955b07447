#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <set>

#include "adapt/case.h"
#include "adapt/shapes.h"
#include "case_support.h"
#include "fem/solve.h"
#include "mesher/delaunay_mesh.h"
#include "tests/support/temporary_folder.h"

namespace parmesan {
namespace {

using support::TemporaryFolder;

using Catch::Contains;
using support::domain_of_case;
using support::issue_text;
using support::issues_of_geometry;
using support::with_geometry;

/// Half the sum of cross products along the segments: the area when the outside goes
/// counter-clockwise and holes clockwise.
double swept_area(const Domain& domain, int label) {
  double area = 0.0;
  for (const Segment& s : domain.segments) {
    if (s.label != label) continue;
    area += 0.5 * cross(domain.points[static_cast<std::size_t>(s.a)], domain.points[static_cast<std::size_t>(s.b)]);
  }
  return area;
}

/// Side of a rectangle's segment by where its midpoint lies.
std::string name_at(const Domain& domain, const Point& p) {
  for (const Segment& s : domain.segments) {
    const Point m =
        midpoint(domain.points[static_cast<std::size_t>(s.a)], domain.points[static_cast<std::size_t>(s.b)]);
    if (norm(m - p) < 1e-12) return label_name(domain.label_names, s.label);
  }
  return "";
}

const std::string kTriangle = "3 2 0 1\n1 0 0\n2 1 0\n3 0 1\n3 1\n1 1 2 5\n2 2 3 5\n3 3 1 9\n0\n";

}  // namespace

TEST_CASE("A rectangle has its sides labelled from 1", "[adapt][case]") {
  const Domain domain = domain_of_case(R"("rectangle": {"min": [-1, 0], "max": [1, 3]})");
  CHECK(name_at(domain, {-1.0, 1.5}) == "left");
  CHECK(name_at(domain, {1.0, 1.5}) == "right");
  CHECK(name_at(domain, {0.0, 0.0}) == "bottom");
  CHECK(name_at(domain, {0.0, 3.0}) == "top");
  std::set<int> labels;
  for (const Segment& s : domain.segments) labels.insert(s.label);
  CHECK(labels == std::set<int>{1, 2, 3, 4});
}

TEST_CASE("Sides can be given other names", "[adapt][case]") {
  const Domain domain = domain_of_case(R"("rectangle": {"min": [0, 0], "max": [2, 2]}, "labels": {"left": "inlet"})");
  CHECK(name_at(domain, {0.0, 1.0}) == "inlet");
  CHECK(name_at(domain, {2.0, 1.0}) == "right");
  CHECK_THAT(issues_of_geometry(R"("rectangle": {"min": [0, 0], "max": [2, 2]}, "labels": {"lef": "inlet"})"),
             Catch::Contains("did you mean 'left'"));
  CHECK_THAT(issues_of_geometry(R"("rectangle": {"min": [0, 0], "max": [2, 2]}, "labels": ["inlet"])"),
             Catch::Contains("is for polygons"));
}

TEST_CASE("A polygon takes a name per side, holes, regions, points and segments", "[adapt][case]") {
  const Domain domain = domain_of_case(R"("polygon": [[0, 0], [4, 0], [4, 4], [0, 4]],
      "labels": ["wall", "out", "wall", "in"],
      "holes": [[[1, 1], [2, 1], [1, 2]], {"disc": {"center": [3, 3], "radius": 0.5, "points": 12}, "label": "pipe"}],
      "regions": {"steel": [0.5, 0.5], "air": [3.5, 0.5]},
      "points": [[0.25, 2]], "segments": [{"from": [2.5, 0.5], "to": [2.5, 1.5], "label": "crack"}])");
  CHECK(name_at(domain, {2.0, 0.0}) == "wall");
  CHECK(name_at(domain, {2.0, 4.0}) == "wall");
  CHECK(name_at(domain, {4.0, 2.0}) == "out");
  CHECK(name_at(domain, {1.5, 1.0}) == "hole1");
  CHECK(name_at(domain, {2.5, 1.0}) == "crack");
  REQUIRE(domain.holes.size() == 2);
  CHECK((domain.holes[0].x > 1.0 && domain.holes[0].y > 1.0 && domain.holes[0].x + domain.holes[0].y < 3.0));
  CHECK(norm(domain.holes[1] - Point{3.0, 3.0}) < 0.5);
  REQUIRE(domain.regions.size() == 2);
  CHECK(label_name(domain.region_names, domain.regions[1].region) == "air");
  CHECK(domain.points.size() == 4 + 3 + 12 + 1 + 2);
}

TEST_CASE("A segment with a label per side is a crack, and both sides need a condition", "[adapt][case]") {
  const std::string slit = R"("rectangle": {"min": [-1, -1], "max": [1, 1]},
      "segments": [{"from": [0, 0], "to": [1, 0], "label": "above", "label_right": "below"}])";
  const Domain domain = domain_of_case(slit);
  const Segment& crack = domain.segments.back();
  REQUIRE(crack.label_right.has_value());
  CHECK(label_name(domain.label_names, crack.label) == "above");
  CHECK(label_name(domain.label_names, *crack.label_right) == "below");
  CHECK(domain.points[static_cast<std::size_t>(crack.b)] == Point{1.0, 0.0});
  const std::string sides = R"("left": {"dirichlet": 0}, "right": {"dirichlet": 0}, "bottom": {"dirichlet": 0},
      "top": {"dirichlet": 0})";
  const std::string open =
      issue_text(R"({"geometry": {)" + slit + R"(}, "problem": {"boundary": {)" + sides + R"(}}})");
  CHECK_THAT(open, Catch::Contains("no condition for the sides 'above', 'below'"));
}

TEST_CASE("A disc's polygon is inscribed and approaches the circle", "[adapt][case]") {
  const Domain domain = domain_of_case(R"("disc": {"center": [1, 2], "radius": 3, "points": 1000})");
  for (const Point& p : domain.points) CHECK(norm(p - Point{1.0, 2.0}) == Approx(3.0).epsilon(1e-14));
  // (n / 2) r^2 sin(2 pi / n) = pi r^2 (1 - (2 pi / n)^2 / 6 + ...)
  CHECK(swept_area(domain, 1) == Approx(M_PI * 9.0 * (1.0 - 4.0 * M_PI * M_PI / 6e6)).epsilon(1e-9));
}

TEST_CASE("NACA airfoils have the tabulated thickness and camber", "[adapt][case]") {
  SECTION("0012: symmetric, 12 % thick at 30 % of the chord") {
    const Ring ring = naca_airfoil(*naca_section("0012"), 2000, {});
    double thickest = 0.0;
    double where = 0.0;
    for (const Point& p : ring) {
      if (p.y > thickest) where = p.x;
      thickest = std::max(thickest, p.y);
    }
    CHECK(thickest == Approx(0.06).epsilon(2e-3));
    CHECK(where == Approx(0.3).margin(0.005));
    CHECK(ring.front() == Point{1.0, 0.0});
    CHECK((ring[1].y > 0.0 && ring[1].y < 1e-5));  // 2e-6 from a closed trailing edge
    CHECK(ring[1000] == Point{0.0, 0.0});
    for (std::size_t i = 1; i < 1000; ++i) CHECK(ring[i].y == Approx(-ring[2000 - i].y).epsilon(1e-12));
  }
  SECTION("2412: mean line 2 % high at 40 %") {
    const Ring ring = naca_airfoil(*naca_section("2412"), 4000, {});
    double upper = 0.0;
    double lower = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (std::abs(ring[i].x - 0.4) > 0.001) continue;
      (i < 2000 ? upper : lower) = ring[i].y;
    }
    CHECK(0.5 * (upper + lower) == Approx(0.02).margin(1e-4));
  }
  SECTION("placed by chord, angle and leading edge: nose up means tail down") {
    const Ring ring = naca_airfoil(*naca_section("0012"), 101, {2.0, 90.0, {5.0, 7.0}});
    CHECK(ring.front().x == Approx(5.0).epsilon(1e-14));
    CHECK(ring.front().y == Approx(5.0).epsilon(1e-14));
  }
}

TEST_CASE("NACA sections of five digits have the lift that their first digit stands for", "[adapt][case]") {
  // Thin airfoils: 2 integral over 0..pi of z'(x) cos(theta), x = (1 - cos theta)/2 (Glauert 1926), by the mid line of
  // the polygon; 0.15 for each unit of the first digit. The table's places have three
  // digits, which leaves 2.8 % for 210.
  const char* code = GENERATE("21012", "22012", "23012", "24012", "25012", "43018");
  constexpr int n = 4000;
  const Ring ring = naca_airfoil(*naca_section(code), 2 * n, {});
  double lift = 0.0;
  for (int i = 1; i + 2 < n; ++i) {
    const auto middle = [&](int k) {
      return midpoint(ring[static_cast<std::size_t>(k)], ring[static_cast<std::size_t>(2 * n - k)]);
    };
    const Vector d = middle(i + 1) - middle(i);
    const double theta = std::acos(1.0 - 2.0 * (middle(i) + 0.5 * d).x);
    const double theta_next = std::acos(1.0 - 2.0 * middle(i + 1).x);
    lift += 2.0 * d.y / d.x * std::cos(theta) * (std::acos(1.0 - 2.0 * middle(i).x) - theta_next);
  }
  CHECK(lift == Approx(0.15 * (code[0] - '0')).epsilon(0.03));
}

TEST_CASE("Without points an airfoil is the true curve", "[adapt][case]") {
  const Domain domain =
      domain_of_case(R"("naca": {"code": "2412", "angle": 5, "channel": {"min": [-1, -1], "max": [2, 1]}})");
  REQUIRE(domain.segments.size() == 5);
  const Segment& airfoil = domain.segments.back();
  REQUIRE_FALSE(airfoil.is_straight());
  const Curve& curve = domain.curves[static_cast<std::size_t>(airfoil.curve)];
  for (const Point& p : naca_airfoil(*naca_section("2412"), 50, {1.0, 5.0, {}}))
    CHECK(norm(curve.at(curve.nearest(p)) - p) < 1e-14);
  for (double t = 0.011; t < 1.0; t += 0.02) {
    const Vector rate = (1.0 / 2e-7) * (curve.at(t + 1e-7) - curve.at(t - 1e-7));
    CHECK(norm(curve.derivative(t) - rate) < 1e-6 * norm(rate));
  }
  CHECK(curve.kinks().empty());
}

TEST_CASE("An airfoil is a hole of its channel", "[adapt][case]") {
  const Domain domain =
      domain_of_case(R"("naca": {"code": "2412", "points": 120, "channel": {"min": [-1, -1], "max": [2, 1]}})");
  REQUIRE(domain.holes.size() == 1);
  CHECK(domain.segments.size() == 4 + 120);
  CHECK(label_name(domain.label_names, domain.segments.back().label) == "airfoil");
  CHECK_THAT(issues_of_geometry(R"("naca": {"code": "0012", "channel": {"min": [0, -1], "max": [2, 1]}})"),
             Catch::Contains("inside the channel"));
  CHECK_THAT(issues_of_geometry(R"("naca": {"code": "23112", "channel": {"min": [-1, -1], "max": [2, 1]}})"),
             Catch::Contains("/geometry/naca/code: must be four digits") && Catch::Contains("'23012'"));
}

TEST_CASE("interior_point lies inside polygons that are thin, hooked or clockwise", "[adapt][case]") {
  CHECK(interior_point({{0, 0}, {0, 1}, {1, 0}}).x > 0.0);
  // A comb: the triangle at the leftmost corner holds other corners.
  const Ring comb{{0, 0}, {10, -5}, {1, 0.1}, {10, 5}, {0.5, 0.2}, {10, 9}};
  const Point p = interior_point(comb);
  bool inside = false;
  for (std::size_t i = 0; i < comb.size(); ++i) {
    const Point a = comb[i];
    const Point b = comb[(i + 1) % comb.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) inside = !inside;
  }
  CHECK(inside);
}

TEST_CASE("Geometry that cannot be used is refused with what is allowed", "[adapt][case][errors]") {
  CHECK(issues_of_geometry(R"("rectangle": {"min": [0, 1], "max": [1, 1]})") ==
        "/geometry/rectangle: 'min' must be smaller than 'max' in both coordinates\n");
  CHECK(issues_of_geometry(R"("disc": {"radius": 1}, "polygon": [[0,0],[1,0],[0,1]])") ==
        "/geometry: give exactly one of 'rectangle', 'disc', 'ellipse', 'polygon', 'curves', 'naca', 'file', 'union', "
        "'intersection', 'difference'; found 'disc', 'polygon'\n");
  CHECK_THAT(issues_of_geometry(R"("rectangel": {"min": [0, 0], "max": [1, 1]})"), Catch::Contains("mean 'rectangle'"));
  CHECK(issues_of_geometry(R"("polygon": [[0, 0], [1, 0]])") ==
        "/geometry/polygon: must be a list of at least 3 points, not a list of 2\n");
  CHECK(issues_of_geometry(R"("polygon": [[0, 0], [1, 0], [0, 1, 2]])") ==
        "/geometry/polygon/2: must be a point [x, y], not a list of 3\n");
  CHECK(issues_of_geometry(R"("polygon": [[0, 0], [1, 0], [0, 1]], "labels": ["a", "b"])") ==
        "/geometry/labels: must name each of the 3 sides of the polygon, not 2\n");
  CHECK_THROWS_AS(domain_of_case(R"("polygon": [[0, 0], [1, 1], [1, 0], [0, 1]])"), GeometryError);
}

TEST_CASE("A geometry file is read from beside the case", "[adapt][case]") {
  const TemporaryFolder folder;
  folder.write("inside/triangle.poly", kTriangle);
  const std::string text = R"({"geometry": {"file": "inside/triangle.poly", "labels": {"9": "west"}},
      "problem": {"boundary": {"*": {"dirichlet": 0}}}})";
  const Case c = parse_case(text, folder / "case.json");
  CHECK(c.domain.points.size() == 3);
  CHECK(c.domain.label_names.at(9) == "west");
  CHECK(c.problem.boundary.contains(5));
  CHECK(c.problem.boundary.contains(9));
}

TEST_CASE("in a file, too, * stands for the sides of the domain, not for lines between regions", "[adapt][case]") {
  // Region 1 with x < 1, region 2 beyond; bottom and top have the label 3. The border has no edge, one without a
  // label, one with that of the top, or one with a label of its own.
  const std::string border = GENERATE("", "2 5 0\n", "2 5 3\n", "2 5 4\n");
  const TemporaryFolder folder;
  folder.write("two.mesh",
               "MeshVersionFormatted 2\nDimension 2\nVertices 6\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n"
               "Triangles 4\n1 2 5 1\n1 5 4 1\n2 3 6 2\n2 6 5 2\n"
               "Edges " +
                   std::string(border.empty() ? "6" : "7") + "\n1 2 3\n2 3 3\n3 6 2\n6 5 3\n5 4 3\n4 1 1\n" + border +
                   "End\n");
  const auto value_on_border = [&](const std::string& boundary) {
    const Case c = parse_case(R"({"geometry": {"file": "two.mesh", "points": [[1, 0.5]]},
        "problem": {"diffusion": {"1": 40, "2": 1}, "boundary": {)" +
                                  boundary + "}}}",
                              folder / "case.json");
    const Mesh mesh = delaunay_mesh(c.domain).mesh;
    const std::vector<double> u = solve(mesh, c.problem).values;
    for (std::size_t v = 0; v < u.size(); ++v)
      if (mesh.points[v] == Point{1, 0.5}) return u[v];
    return std::nan("");
  };
  const std::string ends = R"("1": {"dirichlet": 1}, "2": {"dirichlet": 0}, )";
  // 40 (1 - u) = u
  CHECK(value_on_border(ends + R"("*": {"neumann": 0})") == Approx(40.0 / 41).epsilon(1e-12));
  CHECK(value_on_border(R"case("*": {"dirichlet": "x*(2 - x)"})case") < 0.9);  // 1 if it were held
  if (border == "2 5 4\n") CHECK(value_on_border(ends + R"("4": {"dirichlet": 7}, "*": {"neumann": 0})") == 7.0);
}

TEST_CASE("A case cannot name files elsewhere or that are not files", "[adapt][case][errors]") {
  const TemporaryFolder folder;
  folder.write("inside/secret.poly", kTriangle);
  std::filesystem::create_symlink(folder / "inside/secret.poly", folder / "inside/link.poly");
  std::filesystem::create_directories(folder / "case");
  std::filesystem::create_symlink(folder / "inside/secret.poly", folder / "case/out.poly");
  const auto issue = [&folder](const std::string& name, const std::string& file) {
    try {
      parse_case(with_geometry("\"file\": \"" + name + "\""), folder / file);
    } catch (const CaseError& error) {
      return error.issues().front().problem;
    }
    return std::string();
  };
  CHECK_THAT(issue("/etc/passwd", "case.json"), Catch::Contains("beside or below"));
  CHECK_THAT(issue("../secret.poly", "case/case.json"), Catch::Contains("beside or below"));
  CHECK_THAT(issue("none.poly", "case.json"), Catch::Contains("no such file"));
  CHECK_THAT(issue("inside", "case.json"), Catch::Contains("not a regular file"));
  CHECK_THAT(issue("out.poly", "case/case.json"), Catch::Contains("a link leads out"));
  CHECK_THAT(issue("a\\u0000b", "case.json"), Catch::Contains("beside or below"));
  CHECK(issue("inside/link.poly", "case.json").empty());
}

TEST_CASE("regions that share a name are meant together", "[adapt][case]") {
  const TemporaryFolder folder;
  const auto square = [](const std::string& name, int x) {
    const std::string a = std::to_string(x), b = std::to_string(x + 1);
    return R"({"type": "Feature", "properties": {"name": ")" + name +
           R"("}, "geometry": {"type": "Polygon", "coordinates": [[[)" + a + ",0],[" + b + ",0],[" + b + ",1],[" + a +
           ",1],[" + a + ",0]]]}}";
  };
  const auto collection = [](const std::string& features) {
    return R"({"type": "FeatureCollection", "features": [)" + features + "]}";
  };
  folder.write("inside/three.geojson",
               collection(square("steel", 0) + "," + square("air", 1) + "," + square("steel", 2)));
  folder.write("inside/one.geojson", collection(square("lake", 0)));
  const auto read = [&](const std::string& file, const std::string& rest, const std::string& diffusion) {
    return parse_case(R"({"geometry": {"file": "inside/)" + file + R"("})" + rest + R"(, "problem": {"diffusion": )" +
                          diffusion + R"(, "boundary": {"*": {"dirichlet": 0}}}})",
                      folder / "case.json");
  };
  const std::string diffusion = GENERATE(R"({"steel": 40, "*": 1})", R"({"steel": 40, "air": 1})");
  const Case three = read("three.geojson", "", diffusion);
  REQUIRE(three.domain.regions.size() == 3);
  for (const RegionSeed& seed : three.domain.regions) {
    const bool is_steel = label_name(three.domain.region_names, seed.region) == "steel";
    CHECK(three.problem.diffusion(seed.point, seed.region).xx == (is_steel ? 40.0 : 1.0));
  }
  const auto required = [&](const std::string& file, const std::string& name) {
    const std::string text = R"({"geometry": {"file": "inside/)" + file + R"(", "required": [")" + name +
                             R"("]}, "problem": {"interpolate": "x"}, "functionals": {"all": {"integral": ")" + name +
                             R"("}}})";
    return parse_case(text, folder / "case.json").required_regions.size();
  };
  CHECK(required("three.geojson", "steel") == 2);
  CHECK(required("three.geojson", "air") == 1);
  CHECK(required("one.geojson", "lake") == 1);  // the whole domain, which has no seed
}

TEST_CASE("a merge tolerance makes a border of features a little apart, also within an operation", "[adapt][case]") {
  const TemporaryFolder folder;
  folder.write("two.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "a"}, "geometry":
      {"type": "Polygon", "coordinates": [[[0,0],[1,0],[1,1],[0,1],[0,0]]]}},
    {"type": "Feature", "properties": {"name": "b"}, "geometry":
      {"type": "Polygon", "coordinates": [[[1.0000001,0],[2,0],[2,1],[1.0000001,1],[1.0000001,0]]]}}]})");
  const std::string file = R"("file": "two.geojson")";
  const std::string far = R"({"rectangle": {"min": [5, 0], "max": [6, 1]}})";
  for (const std::string& shape : {file, R"("union": [{)" + file + "}, " + far + "]"}) {
    const Case read = parse_case(R"({"geometry": {)" + shape + R"(, "merge_tolerance": 1e-6},
                                     "problem": {"interpolate": "x"}})",
                                 folder / "case.json");
    const Domain& domain = read.domain;
    for (const Segment& s : domain.segments) {
      const auto is_on_seam = [&](int p) {
        return std::abs(domain.points[static_cast<std::size_t>(p)].x - 1.0) < 1e-5;
      };
      CHECK((label_name(domain.label_names, s.label) == "a|b") == (is_on_seam(s.a) && is_on_seam(s.b)));
    }
  }
}

TEST_CASE("holes lie apart and inside of the domain", "[adapt][case][errors]") {
  const std::string square = R"("rectangle": {"min": [-1, -1], "max": [1, 1]}, "holes": )";
  const std::string disc = R"({"disc": {"radius": 0.5}})";
  const std::string island = GENERATE(R"([[-0.2, -0.2], [0.2, -0.2], [0.2, 0.2], [-0.2, 0.2]])",
                                      R"({"disc": {"center": [0.3, 0.1], "radius": 0.1}})");
  CHECK_THAT(issues_of_geometry(square + "[" + disc + ", " + island + "]"),
             Contains("/geometry/holes/1: lies in or around"));
  CHECK_THAT(issues_of_geometry(square + "[" + island + ", " + disc + "]"),
             Contains("/geometry/holes/1: lies in or around"));
  CHECK_THAT(issues_of_geometry(square + R"([{"disc": {"center": [1.5, 0], "radius": 0.1}}])"),
             Contains("/geometry/holes/0: does not lie inside of the domain"));
  CHECK(domain_of_case(square + "[" + island + R"(, {"disc": {"center": [-0.7, 0], "radius": 0.1}}])").holes.size() ==
        2);
}

}  // namespace parmesan
