#include "adapt/io/geojson.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "mesher/delaunay_mesh.h"
#include "mesher/errors.h"
#include "mesher/validate.h"

using parmesan::delaunay_mesh;
using parmesan::Domain;
using parmesan::FileError;
using parmesan::Mesh;
using parmesan::parse_geojson;

namespace {

const std::string square = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";

std::string polygon(const std::string& rings) { return R"({"type":"Polygon","coordinates":[)" + rings + "]}"; }

std::string feature(const std::string& name, const std::string& geometry) {
  return R"({"type":"Feature","properties":{"name":")" + name + R"("},"geometry":)" + geometry + "}";
}

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

Domain parse(const std::string& text) { return parse_geojson(text, "t.geojson"); }

/// The area of a region, of all for -1.
double area_within(const Mesh& mesh, int region = -1) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (region >= 0 && mesh.regions[t] != region) continue;
    const auto point = [&mesh, t](std::size_t k) {
      return mesh.points[static_cast<std::size_t>(mesh.triangles[t][k])];
    };
    sum += 0.5 * parmesan::doubled_area(point(0), point(1), point(2));
  }
  return sum;
}

double area_of(const std::string& text) { return area_within(delaunay_mesh(parse(text)).mesh); }

}  // namespace

TEST_CASE("A GeoJSON polygon is a domain with its holes, whatever the direction of rings", "[adapt][io][geojson]") {
  const std::string hole = GENERATE("[[1,1],[1,2],[2,2],[2,1],[1,1]]", "[[1,1],[2,1],[2,2],[1,2],[1,1]]",
                                    "[[1,1,9],[2,1,9],[2,2,9],[1,2,9]]");
  const Domain domain = parse(polygon(square + "," + hole));
  CHECK(domain.label_names == parmesan::LabelNames{{1, "boundary"}, {2, "hole1"}});
  CHECK(area_within(delaunay_mesh(domain).mesh) == Approx(15.0).epsilon(1e-14));
}

TEST_CASE("A multi-polygon has an island in its lake", "[adapt][io][geojson]") {
  const std::string lake = "[[1,1],[3,1],[3,3],[1,3],[1,1]]";
  const std::string island = "[[1.5,1.5],[2.5,1.5],[2.5,2.5],[1.5,2.5],[1.5,1.5]]";
  CHECK(area_of(feature("a", R"({"type":"MultiPolygon","coordinates":[[)" + square + "," + lake + "],[" + island +
                                 "]]}")) == Approx(13.0).epsilon(1e-14));
}

TEST_CASE("Features that share a border are regions with their names", "[adapt][io][geojson]") {
  const std::string left = feature("left", polygon("[[0,0],[1,0],[1,2],[0,2],[0,0]]"));
  const std::string right =
      feature("right", polygon("[[1,0],[3,0],[3,2],[1,2],[1,0]],[[1.5,0.5],[2,0.5],[2,1],[1.5,1],[1.5,0.5]]"));
  const std::string far = feature("", polygon("[[5,0],[6,0],[6,1],[5,1],[5,0]]"));
  const Domain domain = parse(collection(left + "," + right + "," + far));
  const Mesh mesh = delaunay_mesh(domain).mesh;
  CHECK_NOTHROW(validate(mesh));
  CHECK(mesh.region_names == parmesan::LabelNames{{1, "left"}, {2, "right"}, {3, "feature3"}});
  CHECK(area_within(mesh, 1) == Approx(2.0).epsilon(1e-14));
  CHECK(area_within(mesh, 2) == Approx(3.75).epsilon(1e-14));
  CHECK(area_within(mesh, 3) == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("Where features overlap the smallest counts", "[adapt][io][geojson]") {
  const std::string inner = feature("inner", polygon("[[1,1],[2,1],[2,2],[1,2],[1,1]]"));
  const std::string outer = feature("outer", polygon(square));
  const bool inner_first = GENERATE(true, false);
  const Mesh mesh = delaunay_mesh(parse(collection(inner_first ? inner + "," + outer : outer + "," + inner))).mesh;
  CHECK(area_within(mesh, inner_first ? 1 : 2) == Approx(1.0).epsilon(1e-14));
  CHECK(area_within(mesh, inner_first ? 2 : 1) == Approx(15.0).epsilon(1e-14));
}

TEST_CASE("A border between two features has a name of its own, that of a feature is for its outer sides",
          "[adapt][io][geojson]") {
  const std::string left = feature("left", polygon("[[0,0],[1,0],[1,2],[0,2],[0,0]]"));
  const std::string right = feature("right", polygon("[[1,0],[3,0],[3,2],[1,2],[1,0]]"));
  const Domain domain = parse(collection(left + "," + right));
  for (const parmesan::Segment& s : domain.segments) {
    const auto x = [&](int p) { return domain.points[static_cast<std::size_t>(p)].x; };
    const bool is_border = x(s.a) == 1.0 && x(s.b) == 1.0;
    CHECK((parmesan::label_name(domain.label_names, s.label) == "left|right") == is_border);
  }
}

TEST_CASE("Rings of one feature that run together leave no side inside of it", "[adapt][io][geojson]") {
  const std::string cells =
      R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[1,1],[0,1],[0,0]]],[[[1,0],[2,0],[2,1],[1,1],[1,0]]]]})";
  const std::string far = feature("far", polygon("[[5,0],[6,0],[6,1],[5,1],[5,0]]"));
  for (const std::string& text : {cells, collection(feature("cells", cells) + "," + far)}) {
    const Domain domain = parse(text);
    for (const parmesan::Segment& s : domain.segments) {
      const auto x = [&](int p) { return domain.points[static_cast<std::size_t>(p)].x; };
      CHECK_FALSE((x(s.a) == 1.0 && x(s.b) == 1.0));
    }
  }
}

TEST_CASE("A merge tolerance makes one border of rings a little apart, as if they had been drawn so",
          "[adapt][io][geojson]") {
  constexpr double tolerance = 1e-6;
  const auto length_by_name = [](const Domain& domain) {
    const Mesh mesh = delaunay_mesh(domain).mesh;
    std::map<std::string, double> sum;
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const auto end = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(mesh.edges[e][k])]; };
      sum[parmesan::label_name(mesh.label_names, mesh.labels[e])] +=
          std::hypot(end(1).x - end(0).x, end(1).y - end(0).y);
    }
    return sum;
  };
  const auto merged = [](const std::string& text) {
    return parse_geojson(text, "t.geojson", parmesan::Crossings::Refuse, tolerance);
  };
  const std::string left = "[[0,0],[1,0],[1,1],[0,1],[0,0]]";
  const std::string right = "[[1.0000001,0],[2,0],[2,1],[1.0000001,1],[1.0000001,0]]";

  SECTION("of two features") {
    const Domain domain = merged(collection(feature("a", polygon(left)) + "," + feature("b", polygon(right))));
    const std::map<std::string, double> lengths = length_by_name(domain);
    REQUIRE(lengths.size() == 3);
    for (const auto& [name, length] : std::map<std::string, double>{{"a", 3.0}, {"b", 3.0}, {"a|b", 1.0}})
      CHECK(lengths.at(name) == Approx(length).epsilon(1e-6));
  }
  SECTION("of two features with points where the other has none") {
    const std::string bent = "[[1.0000001,0],[2,0],[2,1],[1,1],[1.0000001,0.5],[1.0000001,0]]";
    const Domain domain = merged(collection(feature("a", polygon(left)) + "," + feature("b", polygon(bent))));
    const std::map<std::string, double> lengths = length_by_name(domain);
    REQUIRE(lengths.size() == 3);
    for (const auto& [name, length] : std::map<std::string, double>{{"a", 3.0}, {"b", 3.0}, {"a|b", 1.0}})
      CHECK(lengths.at(name) == Approx(length).epsilon(1e-6));
    CHECK_THAT(delaunay_mesh(domain).repairs.at(1), Catch::Contains("made 1 bend"));
  }
  SECTION("of one") {
    const Domain domain = merged(R"({"type":"MultiPolygon","coordinates":[[)" + left + "],[" + right + "]]}");
    const std::map<std::string, double> lengths = length_by_name(domain);
    REQUIRE(lengths.size() == 1);
    CHECK(lengths.at("boundary") == Approx(6.0).epsilon(1e-6));
    CHECK_THAT(delaunay_mesh(domain).repairs.at(0), Catch::Contains("by the tolerance 1e-06 merged 2 points"));
  }
  SECTION("which is told of once where rings do not run together") {
    const std::vector<std::string> repairs =
        delaunay_mesh(merged(polygon("[[0,0],[1,0],[1.0000001,0],[1,1],[0,1],[0,0]]"))).repairs;
    CHECK_THAT(repairs.at(0), Catch::Contains("by the tolerance 1e-06 merged 1 point"));
    CHECK(std::count_if(repairs.begin(), repairs.end(),
                        [](const std::string& repair) { return repair.find("merged") != std::string::npos; }) == 1);
  }
}

TEST_CASE("Features whose rings cross are refused, or split there", "[adapt][io][geojson]") {
  const std::string shifted = feature("shifted", polygon("[[3,3],[6,3],[6,6],[3,6],[3,3]]"));
  const std::string text = collection(feature("first", polygon(square)) + "," + shifted);
  CHECK_THROWS_AS(parse(text), parmesan::GeometryError);
  const Mesh mesh = delaunay_mesh(parse_geojson(text, "t.geojson", parmesan::Crossings::Split)).mesh;
  CHECK(area_within(mesh, 1) == Approx(15.0).epsilon(1e-14));
  CHECK(area_within(mesh, 2) == Approx(9.0).epsilon(1e-14));
}

TEST_CASE("Rings that share sides enclose what an odd number of them does", "[adapt][io][geojson]") {
  std::string cells;
  for (int i = 0; i < 9; ++i) {
    const auto at = [i](int dx, int dy) {
      return "[" + std::to_string(i % 3 + dx) + "," + std::to_string(i / 3 + dy) + "]";
    };
    cells +=
        (i > 0 ? ",[[" : "[[") + at(0, 0) + "," + at(1, 0) + "," + at(1, 1) + "," + at(0, 1) + "," + at(0, 0) + "]]";
  }
  CHECK(area_of(R"({"type":"MultiPolygon","coordinates":[)" + cells + "]}") == Approx(9.0).epsilon(1e-14));
  const std::string notch = "[[1,0],[2,0],[2,1],[1,1],[1,0]]";
  CHECK(area_of(polygon(square + "," + notch)) == Approx(15.0).epsilon(1e-14));
  CHECK(area_of(feature("named", polygon(square + "," + notch))) == Approx(15.0).epsilon(1e-14));
  const std::string other = feature("other", polygon("[[5,0],[6,0],[6,1],[5,1],[5,0]]"));
  CHECK(area_of(collection(feature("notched", polygon(square + "," + notch)) + "," + other)) ==
        Approx(16.0).epsilon(1e-14));
  CHECK_THROWS_AS(parse(polygon(square + "," + square)), parmesan::GeometryError);
}

TEST_CASE("Holes outside of their polygon's first ring are refused", "[adapt][io][geojson][errors]") {
  const std::string around = "[[-1,-1],[5,-1],[5,5],[-1,5],[-1,-1]]";
  const std::string beside = "[[6,0],[7,0],[7,1],[6,1],[6,0]]";
  const std::string half = "[[3,1],[4,0],[6,2],[4,4],[3,1]]";  // touches two corners
  const std::string far = feature("far", polygon("[[8,8],[9,8],[9,9],[8,9],[8,8]]"));
  for (const std::string& hole : {around, beside, half}) {
    const std::string rings = polygon(square + "," + hole);
    CHECK_THROWS_WITH(parse(rings), Catch::Contains("ring 1 of a polygon, does not lie inside"));
    CHECK_THROWS_WITH(parse(collection(feature("a", rings) + "," + far)),
                      Catch::Contains("ring 1 of a polygon of 'a', does not lie inside"));
  }
  const std::string lake = "[[1,1],[3,1],[3,3],[1,3],[1,1]]";
  const std::string island = "[[1.5,1.5],[2.5,1.5],[2.5,2.5],[1.5,2.5],[1.5,1.5]]";
  CHECK(area_of(polygon(square + "," + lake + "," + island)) == Approx(13.0).epsilon(1e-14));
}

TEST_CASE("The only feature gives the region its name, and sides theirs", "[adapt][io][geojson]") {
  const Domain domain = parse(collection(feature("lake", polygon(square))));
  CHECK(domain.region_names == parmesan::LabelNames{{0, "lake"}});
  CHECK(domain.label_names == parmesan::LabelNames{{1, "boundary"}});
}

TEST_CASE("Faults of a GeoJSON text are refused with line and pointer", "[adapt][io][geojson][errors]") {
  const auto message_of = [](const std::string& text) -> std::string {
    try {
      parse(text);
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  };
  using Catch::Contains;
  CHECK_THAT(message_of("{\n\"type\": }"), Contains("t.geojson:2"));
  CHECK_THAT(message_of(""), Contains("is not JSON"));
  CHECK_THAT(message_of("[]"), Contains("must be an object"));
  CHECK_THAT(message_of("{}"), Contains("has no \"type\""));
  CHECK_THAT(message_of(R"({"type":"Point","coordinates":[0,0]})"), Contains("/type must be Polygon"));
  CHECK_THAT(message_of(collection("\n" + feature("a", "{\"type\":\"Polygon\",\n\"coordinates\":[[[0,0],\n[1]]]}"))),
             Contains("t.geojson:4: /features/0/geometry/coordinates/0/1 must be two numbers"));
  CHECK_THAT(message_of(collection("")), Contains("has no polygons"));
  CHECK_THAT(message_of(collection("\n" + feature("a", polygon(square)).insert(1, "\n\"type\":\"Point\",\n"))),
             Contains("t.geojson:4: /features/0/type is given twice"));
  CHECK_THAT(message_of(polygon("[[0,0],[1e999,0],[0,1]]")), Contains("double precision"));
  CHECK_THAT(message_of(std::string(100000, '[')), Contains("too deep"));
  CHECK_THROWS_AS(
      parse(collection(feature("a", polygon(square)) + "," + feature("b", polygon("[[2,2],[6,2],[6,6],[2,6],[2,2]]")))),
      parmesan::GeometryError);
}

TEST_CASE("Neighbours that rounding puts apart have a border, without a tolerance too", "[adapt][io][geojson]") {
  constexpr double offset = 5e6;
  for (int i = 0; i < 40; ++i) {
    const double angle = 0.04 * i;
    const auto place = [&](double u, double v) {
      std::ostringstream text;
      text.precision(17);
      text << "[" << offset + std::cos(angle) * u - std::sin(angle) * v << ","
           << offset + std::sin(angle) * u + std::cos(angle) * v << "]";
      return text.str();
    };
    const auto ring = [&place](const std::vector<std::pair<double, double>>& corners) {
      std::string text = "[";
      for (const auto& [u, v] : corners) text += place(u, v) + ",";
      return text + place(corners.front().first, corners.front().second) + "]";
    };
    const std::string left = feature("a", polygon(ring({{0, 0}, {1, 0}, {1, 0.1}, {1, 0.7}, {1, 1}, {0, 1}})));
    const std::string right = feature("b", polygon(ring({{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.9}, {1, 0.3}})));
    INFO(angle);
    const Domain domain = parse(collection(left + "," + right));
    const Mesh mesh = delaunay_mesh(domain).mesh;
    CHECK(area_within(mesh, 1) == Approx(1.0).epsilon(1e-7));
    CHECK(area_within(mesh, 2) == Approx(1.0).epsilon(1e-7));
    std::map<std::string, double> lengths;
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const auto end = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(mesh.edges[e][k])]; };
      lengths[parmesan::label_name(mesh.label_names, mesh.labels[e])] +=
          std::hypot(end(1).x - end(0).x, end(1).y - end(0).y);
    }
    CHECK(lengths["a"] == Approx(3.0).epsilon(1e-7));
    CHECK(lengths["b"] == Approx(3.0).epsilon(1e-7));
    CHECK(lengths["a|b"] == Approx(1.0).epsilon(1e-7));
  }
}

TEST_CASE("It is said where rounding was taken back, and not where nothing was", "[adapt][io][geojson]") {
  const std::string left = feature("a", polygon("[[0,0],[1,0],[1,1],[0,1],[0,0]]"));
  const std::string fits = feature("b", polygon("[[1,0],[2,0],[2,1],[1,1],[1,0]]"));
  CHECK(parse(collection(left + "," + fits)).notes.empty());
  const std::string is_apart =
      feature("b", polygon("[[1.0000000000000002,0],[2,0],[2,1],[1,1],[1.0000000000000002,0]]"));
  const std::vector<std::string> notes = parse(collection(left + "," + is_apart)).notes;
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes.front(), Catch::Contains("put 1 ring"));
}

TEST_CASE("Points and lines beside polygons are left out, which is told", "[adapt][io][geojson]") {
  const std::string point = feature("well", R"({"type":"Point","coordinates":[0,0]})");
  const std::string line = feature("road", R"({"type":"LineString","coordinates":[[0,0],[1,1]]})");
  const std::string lines = feature("roads", R"({"type":"MultiLineString","coordinates":[[[0,0],[1,1]]]})");
  const std::string lake = feature("lake", polygon(square));
  const Domain domain = parse(collection(point + "," + lake + "," + line + "," + point + "," + lines));
  CHECK(domain.region_names == parmesan::LabelNames{{0, "lake"}});
  REQUIRE(domain.notes.size() == 1);
  CHECK(domain.notes.front() == "left out what has no area: 1 LineString, 1 MultiLineString, 2 Points");
  CHECK(area_within(delaunay_mesh(domain).mesh) == Approx(16.0).epsilon(1e-14));
  const std::string mixed =
      R"({"type":"GeometryCollection","geometries":[{"type":"MultiPoint","coordinates":[]},)" + polygon(square) + "]}";
  CHECK(parse(feature("a", mixed)).notes == std::vector<std::string>{"left out what has no area: 1 MultiPoint"});
  const std::string far = feature("far", polygon("[[5,0],[6,0],[6,1],[5,1],[5,0]]"));
  CHECK(parse(collection(lake + "," + far + "," + point)).notes ==
        std::vector<std::string>{"left out what has no area: 1 Point"});
  CHECK_THROWS_WITH(parse(collection(point + "," + line)), Catch::Contains("has no polygons"));
  CHECK_THROWS_WITH(parse(collection(lake + "," + feature("", R"({"type":"Circle"})"))),
                    Catch::Contains("/features/1/geometry/type must be Polygon"));
}
