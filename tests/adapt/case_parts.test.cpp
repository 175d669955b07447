#include <catch2/catch.hpp>
#include <map>
#include <string>

#include "adapt/case.h"
#include "case_support.h"
#include "mesher/delaunay_mesh.h"
#include "mesher/geometry/clean.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/temporary_folder.h"

// What holes, segments and points leave of a geometry that they are added to: areas by hand.

namespace parmesan {
namespace {

using Catch::Contains;
using support::TemporaryFolder;

/// Below steel, [0,4] x [0,2], above wood, [0,4] x [2,4].
const std::string kHalves =
    R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"name": "steel"}, "geometry":
    {"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,2],[0,2],[0,0]]]}}, {"type": "Feature", "properties":
    {"name": "wood"}, "geometry": {"type": "Polygon", "coordinates": [[[0,2],[4,2],[4,4],[0,4],[0,2]]]}}]})";

const std::string kSquareFile = R"({"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]]]})";

/// The same as bare edges, with an island in a lake.
const std::string kLake =
    "MeshVersionFormatted 2\nDimension 2\nVertices 12\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n1 1 0\n3 1 0\n3 3 0\n1 3 0\n"
    "1.5 1.5 0\n2.5 1.5 0\n2.5 2.5 0\n1.5 2.5 0\nEdges 12\n1 2 1\n2 3 1\n3 4 1\n4 1 1\n5 6 2\n6 7 2\n7 8 2\n8 5 2\n"
    "9 10 3\n10 11 3\n11 12 3\n12 9 3\nEnd\n";

/// [0,3]^2 with the hole [1,2]^2 and its seed.
const std::string kRing =
    "8 2 0 0\n1 0 0\n2 3 0\n3 3 3\n4 0 3\n5 1 1\n6 2 1\n7 2 2\n8 1 2\n8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n"
    "7 7 8\n8 8 5\n1\n1 1.5 1.5\n";

/// [0,4]^2 with two seeds of different regions.
const std::string kDoubled =
    "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n2\n1 0.5 0.5 5\n2 3 3 6\n";

class PartFiles {
 public:
  PartFiles() {
    folder_.write("halves.geojson", kHalves);
    folder_.write("square.geojson", kSquareFile);
    folder_.write("lake.mesh", kLake);
    folder_.write("ring.poly", kRing);
    folder_.write("doubled.poly", kDoubled);
  }

  Domain domain(const std::string& geometry) const {
    return parse_case(support::with_geometry(geometry), folder_ / "case.json").domain;
  }

  /// As mesh and convert read it, crossings split.
  Domain split(const std::string& geometry) const {
    const std::string path = folder_.write("split.json", R"({"geometry": {)" + geometry + "}}");
    return clean(read_case_geometry(path)->domain, Crossings::Split).domain;
  }

  std::string issues(const std::string& geometry) const {
    try {
      domain(geometry);
    } catch (const GeometryError& error) {
      return error.what();
    }
    return "";
  }

 private:
  TemporaryFolder folder_;
};

/// The area of each region, by its name; "" of all.
std::map<std::string, double> areas(const Domain& domain) {
  const Mesh mesh = delaunay_mesh(domain).mesh;
  std::map<std::string, double> result{{"", oracle::area_of(mesh)}};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Mesh one;
    for (const int v : mesh.triangles[t]) one.points.push_back(mesh.points[static_cast<std::size_t>(v)]);
    one.triangles = {{0, 1, 2}};
    result[label_name(mesh.region_names, mesh.regions[t])] += oracle::area_of(one);
  }
  return result;
}

double area_of_all(const Domain& domain) { return areas(domain)[""]; }

void check_areas(const Domain& domain, double steel, double wood) {
  std::map<std::string, double> found = areas(domain);
  CHECK(found["steel"] == Approx(steel).epsilon(1e-13));
  CHECK(found["wood"] == Approx(wood).epsilon(1e-13));
  CHECK(found[""] == Approx(steel + wood).epsilon(1e-13));
}

/// The length of the straight sides of a name.
double length(const Domain& domain, const std::string& name) {
  double sum = 0.0;
  for (const Segment& s : domain.segments)
    if (label_name(domain.label_names, s.label) == name)
      sum += norm(domain.points[static_cast<std::size_t>(s.b)] - domain.points[static_cast<std::size_t>(s.a)]);
  return sum;
}

}  // namespace

TEST_CASE("Holes that are not inside of their shape as a whole are refused", "[adapt][case][parts][errors]") {
  const PartFiles files;
  const std::string square = R"("polygon": [[0, 0], [4, 0], [4, 4], [0, 4]])";
  const std::string ring = R"("difference": [{)" + square + R"(}, {"disc": {"center": [2, 2], "radius": 1}}])";
  const std::string around = "[[0.5, 0.5], [3.5, 0.5], [3.5, 3.5], [0.5, 3.5]]";
  const std::string small = R"({"disc": {"center": [2, 2], "radius": 0.5}})";
  const std::string file = R"("file": "ring.poly")";
  const auto outline_and_hole = GENERATE_COPY(
      std::pair(square, std::string("[[-1, -1], [5, -1], [5, 5], [-1, 5]]")),
      std::pair(square, std::string("[[3, 2], [4, 0], [9, 2], [4, 4]]")),
      std::pair(square, std::string(R"({"disc": {"center": [4, 2], "radius": 1}})")), std::pair(ring, around),
      std::pair(ring, small), std::pair(ring, std::string("[[8, 8], [9, 8], [9, 9]]")),
      std::pair(file, std::string("[[0.5, 0.5], [2.5, 0.5], [2.5, 2.5], [0.5, 2.5]]")),
      std::pair(file, std::string("[[1.2, 1.2], [1.8, 1.2], [1.5, 1.8]]")),
      std::pair(file, std::string("[[8, 8], [9, 8], [9, 9]]")));
  const std::string geometry = outline_and_hole.first + R"(, "holes": [)" + outline_and_hole.second + "]";
  CAPTURE(geometry);
  CHECK_THAT(files.issues(geometry), Contains("/geometry/holes/0: does not lie inside of the domain"));
  CHECK_THROWS_WITH(files.split(geometry), Contains("/geometry/holes/0: does not lie inside of the domain"));
  CHECK_THAT(files.issues(R"("union": [{"disc": {"center": [2, 2], "radius": 0.5}}, {)" + geometry + "}]"),
             Contains("/geometry/union/1/holes/0: does not lie inside of the domain"));
}

TEST_CASE("Holes may touch sides, corners and each other", "[adapt][case][parts]") {
  const PartFiles files;
  const std::string square = R"("polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": )";
  CHECK(area_of_all(files.domain(square + "[[[1, 0], [2, 1], [1, 2]]]")) == Approx(15.0).epsilon(1e-14));
  CHECK(area_of_all(files.domain(square + "[[[1, 0], [2, 0], [2, 1], [1, 1]]]")) == Approx(15.0).epsilon(1e-14));
  CHECK(area_of_all(files.domain(square + "[[[0, 0], [2, 1], [1, 2]], [[2, 1], [4, 0], [3, 2]]]")) ==
        Approx(16.0 - 1.5 - 1.5).epsilon(1e-14));
  CHECK(area_of_all(files.domain(square + "[[[1, 1], [2, 1], [2, 2], [1, 2]], [[2, 1], [3, 1], [3, 2], [2, 2]]]")) ==
        Approx(14.0).epsilon(1e-14));
}

TEST_CASE("A hole that crosses itself or a border is one where crossings are split", "[adapt][case][parts]") {
  const PartFiles files;
  const std::string bow = R"("polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": [[[1, 1], [3, 3], [3, 1], [1, 3]]])";
  CHECK_THAT(files.issues(bow), Contains("cross"));
  CHECK(area_of_all(files.split(bow)) == Approx(14.0).epsilon(1e-14));
  const std::string across = R"("file": "halves.geojson", "holes": [[[1, 1.5], [3, 1.5], [3, 3], [1, 3]]])";
  CHECK_THAT(files.issues(across), Contains("cross"));
  check_areas(files.split(across), 8.0 - 1.0, 8.0 - 2.0);
}

TEST_CASE("Holes may not have an area in common", "[adapt][case][parts][errors]") {
  const PartFiles files;
  CHECK_THAT(files.issues(R"("polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": [[[1, 1], [2, 1], [2, 2], [1, 2]],
                             [[1.5, 1.5], [3, 1.5], [3, 3], [1.5, 3]]])"),
             Contains("/geometry/holes/1: lies in or around the hole /geometry/holes/0, or across it"));
}

TEST_CASE("Segments, points and holes leave a file's regions as they are", "[adapt][case][parts]") {
  const PartFiles files;
  const std::string file = R"("file": "halves.geojson", )";
  const auto segments = [&](const std::string& list) { return files.domain(file + R"("segments": [)" + list + "]"); };
  check_areas(segments(R"({"from": [1, 0], "to": [1, 2]})"), 8.0, 8.0);
  check_areas(segments(R"({"from": [0, 0], "to": [1.5, 1.5]})"), 8.0, 8.0);
  check_areas(
      segments(R"({"from": [0, 0], "to": [4, 2]}, {"from": [0, 2], "to": [4, 4]}, {"from": [2, 4], "to": [2, 3]})"),
      8.0, 8.0);
  check_areas(segments(R"({"arc": {"center": [1.3, 1], "radius": 0.4, "from": 0, "to": 360}})"), 8.0, 8.0);
  check_areas(
      files.split(file + R"("segments": [{"from": [1, -1], "to": [3, 5]}, {"from": [-1, 2.1], "to": [5, 2.2]}])"), 8.0,
      8.0);
  for (const std::string x : {"1.3333333333333333", "2.6666666666666665"})
    for (const std::string y : {"1.3333333333333333", "0.6666666666666666"})
      check_areas(files.domain(file + R"("points": [[)" + x + ", " + y + "]]"), 8.0, 8.0);
  const std::string hole =
      GENERATE("[[1.2, 1.2], [1.5, 1.2], [1.5, 1.6], [1.2, 1.6]]", "[[2.5, 0.5], [2.8, 0.5], [2.8, 0.9], [2.5, 0.9]]");
  check_areas(files.domain(file + R"("holes": [)" + hole + "]"), 8.0 - 0.12, 8.0);
  check_areas(files.domain(file + R"("holes": [[[0, 0], [4, 0], [4, 2], [0, 2]]])"), 0.0, 8.0);
  check_areas(files.domain(file + R"("holes": [[[1, 0], [3, 0], [3, 2], [1, 2]]])"), 4.0, 8.0);
}

TEST_CASE("A region of a case is for a piece that segments cut off, no other has two", "[adapt][case][parts]") {
  const PartFiles files;
  const std::string file = R"("file": "halves.geojson", )";
  const std::string cut = R"("segments": [{"from": [1, 0], "to": [1, 2]}], )";
  const std::string x = GENERATE("0.5", "3.5");
  std::map<std::string, double> found = areas(files.domain(file + cut + R"("regions": {"copper": [)" + x + ", 1]}"));
  const double copper = x == "0.5" ? 2.0 : 6.0;
  CHECK(found["copper"] == Approx(copper));
  CHECK(found["steel"] == Approx(8.0 - copper));
  CHECK(found["wood"] == Approx(8.0));
  CHECK_THROWS_WITH(delaunay_mesh(files.domain(R"("file": "doubled.poly", )" + cut.substr(0, cut.size() - 2))),
                    Contains("lies in an area that has another region already"));
  const std::string open = R"("segments": [{"from": [1, 0], "to": [1, 1]}], )";
  for (const std::string& segments : {std::string(), open}) {
    const Domain domain = files.domain(file + segments + R"("regions": {"copper": [)" + x + ", 1]}");
    CHECK_THROWS_WITH(delaunay_mesh(domain), Contains("lies in an area that has another region already"));
  }
}

TEST_CASE("What is added to a geometry by the even-odd rule takes nothing away from it", "[adapt][case][parts]") {
  const PartFiles files;
  const std::string square = R"("file": "square.geojson", )";
  const std::string triangle = "[[1.2, 0.2], [1.5, 0.2], [1.5, 0.5]]";
  const std::string lake = R"("file": "lake.mesh", )";
  const std::string box =
      R"([{"from": [1.7, 1.7], "to": [2.2, 1.7], "label": "s"}, {"from": [2.2, 1.7], "to": [2.2, 2.2],
      "label": "s"}, {"from": [2.2, 2.2], "to": [1.7, 2.2], "label": "s"}, {"from": [1.7, 2.2], "to": [1.7, 1.7],
      "label": "s"}])";
  const std::string circle = R"([{"arc": {"center": [2, 2], "radius": 0.3, "from": 0, "to": 360}, "label": "l")";
  for (const std::string& rest : {R"("segments": )" + box, R"("segments": )" + circle + "}]",
                                  R"("segments": )" + circle + R"(, "label_right": "r"}])"}) {
    CAPTURE(rest);
    CHECK(area_of_all(files.domain(square + rest)) == Approx(16.0).epsilon(1e-14));
    CHECK(area_of_all(files.domain(lake + rest)) == Approx(16.0 - 4.0 + 1.0).epsilon(1e-14));
  }
  CHECK(length(files.domain(square + R"("segments": )" + box), "s") == Approx(2.0));
  CHECK(area_of_all(files.domain(square + R"("holes": [)" + triangle + "]")) == Approx(16.0 - 0.045).epsilon(1e-14));
  CHECK(area_of_all(files.domain(lake + R"("holes": [)" + triangle + "]")) == Approx(13.0 - 0.045).epsilon(1e-14));
  CHECK(area_of_all(files.domain(lake + R"("holes": [[[1.6, 1.6], [2, 1.6], [2, 2]]])")) ==
        Approx(13.0 - 0.08).epsilon(1e-14));
  CHECK_THAT(files.issues(lake + R"("holes": [[[1.1, 1.1], [1.3, 1.1], [1.3, 1.4]]])"),
             Contains("/geometry/holes/0: does not lie inside of the domain"));
}

TEST_CASE("A hole stays one where segments run through it", "[adapt][case][parts]") {
  const PartFiles files;
  const std::string through = R"("segments": [{"from": [1, 1], "to": [2, 2]}])";
  CHECK(area_of_all(files.domain(R"("file": "ring.poly", )" + through)) == Approx(8.0).epsilon(1e-14));
  CHECK(area_of_all(files.domain(R"("rectangle": {"min": [0, 0], "max": [3, 3]},
                                    "holes": [[[1, 1], [2, 1], [2, 2], [1, 2]]], )" +
                                 through)) == Approx(8.0).epsilon(1e-14));
  CHECK(area_of_all(files.split(R"("file": "ring.poly", "segments": [{"from": [0, 0], "to": [3, 3]}])")) ==
        Approx(8.0).epsilon(1e-14));
  // What closes a bay makes it a part of the domain, as ever.
  CHECK(area_of_all(files.domain(R"("polygon": [[0, 0], [4, 0], [4, 4], [2, 2], [0, 4]],
                                    "segments": [{"from": [4, 4], "to": [0, 4]}])")) == Approx(16.0).epsilon(1e-14));
}

TEST_CASE("Pieces that an operation leaves of a region are in it", "[adapt][case][parts]") {
  const PartFiles files;
  const std::string file = R"({"file": "halves.geojson"})";
  const auto result = [&](const std::string& name, const std::string& other) {
    return files.domain("\"" + name + "\": [" + file + ", " + other + "]");
  };
  const std::string x = GENERATE("1.0", "1.3333333333333333", "2.0");
  check_areas(result("difference", R"({"polygon": [[)" + x + R"(, 0.5], [3, 0.5], [3, 1.5]]})"),
              8.0 - 0.5 * (3.0 - std::stod(x)), 8.0);
  check_areas(result("difference", R"({"disc": {"center": [)" + x + R"(, 1], "radius": 0.8, "points": 4}})"),
              8.0 - 2.0 * 0.64, 8.0);
  check_areas(result("difference", R"({"rectangle": {"min": [1.9, -1], "max": [2.1, 3]}})"), 7.6, 7.8);
  check_areas(result("intersection", R"({"rectangle": {"min": [0, 1.5], "max": [0.5, 2.25]}})"), 0.25, 0.125);
  check_areas(result("intersection", R"({"disc": {"center": [0, 2], "radius": 1, "points": 4}})"), 0.5, 0.5);
  const std::string inner = R"({"difference": [)" + file + R"(, {"rectangle": {"min": [1.9, -1], "max": [2.1, 3]}}]})";
  check_areas(files.domain(R"("difference": [)" + inner + R"(, {"rectangle": {"min": [0.9, -1], "max": [1.1, 5]}}])"),
              7.6 - 0.4, 7.8 - 0.4);
}

TEST_CASE("Regions that an operation lets run together are refused", "[adapt][case][parts][errors]") {
  const PartFiles files;
  const std::string other =
      GENERATE(R"({"rectangle": {"min": [4, 0], "max": [6, 4]}})", R"({"rectangle": {"min": [3, 1], "max": [6, 3]}})");
  CHECK_THAT(files.issues(R"("union": [{"file": "halves.geojson"}, )" + other + "]"),
             Contains("/geometry/union: nothing parts the regions") && Contains("'steel'") && Contains("'wood'"));
  // One of them alone takes what touches it.
  check_areas(files.domain(R"("union": [{"file": "halves.geojson"}, {"rectangle": {"min": [4, 0], "max": [6, 1]}}])"),
              10.0, 8.0);
}

TEST_CASE("A segment with a condition of its own has it on the part of a side that it lies on",
          "[adapt][case][parts]") {
  const auto length_with = [](const std::string& conditions) {
    const Case input = parse_case(R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}, "segments": [
        {"from": [0.25, 0], "to": [0.75, 0], "label": "heater"}, {"from": [0.75, 0], "to": [0.75, 0.5], "label": "heater"}]},
        "problem": {"boundary": {)" + conditions +
                                      R"("*": {"neumann": 0}}}})",
                                  "heater.json");
    return length(clean(input.domain).domain, "heater");
  };
  CHECK(length_with(R"("heater": {"dirichlet": 1}, )") == Approx(1.0));
  CHECK(length_with("") == Approx(0.5));  // nothing is asked for there: the side is what it was
}

}  // namespace parmesan
