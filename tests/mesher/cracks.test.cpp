#include "mesher/cracks.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "mesher/delaunay_mesh.h"
#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/geometry/arcs.h"
#include "mesher/geometry/clean.h"
#include "mesher/geometry/domain_of_mesh.h"
#include "mesher/index.h"
#include "mesher/io/mesh_file.h"
#include "mesher/metric/background_mesh.h"
#include "mesher/quality.h"
#include "mesher/validate.h"
#include "tests/oracle/domain_cover.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;

namespace {

constexpr int above = 7;
constexpr int below = 8;

struct Cracked {
  Mesh mesh;
  std::vector<std::optional<int>> right_labels;
};

/// A 4 x 4 rectangle mesh of the unit square with cracks along the edges between these vertices (5 j + i).
Cracked cracked_grid(const std::vector<std::array<int, 2>>& cracks) {
  Cracked result{support::rectangle_mesh(4, 4), {}};
  result.right_labels.resize(result.mesh.edges.size());
  for (const auto& crack : cracks) {
    result.mesh.edges.push_back(crack);
    result.mesh.labels.push_back(above);
    result.right_labels.emplace_back(below);
  }
  return result;
}

/// How many groups of triangles that share sides there are at a vertex.
int num_fans(const Mesh& mesh, int vertex) {
  std::vector<std::set<int>> fans;  // of the other corners
  for (const auto& t : mesh.triangles) {
    if (std::find(t.begin(), t.end(), vertex) == t.end()) continue;
    std::set<int> fan(t.begin(), t.end());
    fan.erase(vertex);
    for (auto other = fans.begin(); other != fans.end();) {
      const bool meets = std::any_of(other->begin(), other->end(), [&](int v) { return fan.count(v) > 0; });
      if (meets) fan.insert(other->begin(), other->end());
      other = meets ? fans.erase(other) : other + 1;
    }
    fans.push_back(fan);
  }
  return static_cast<int>(fans.size());
}

int copies_of(const Mesh& mesh, const Point& p) {
  return static_cast<int>(std::count(mesh.points.begin(), mesh.points.end(), p));
}

double length_of(const Mesh& mesh, int label) {
  double sum = 0.0;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (mesh.labels[e] == label) sum += norm(mesh.points[at(mesh.edges[e][1])] - mesh.points[at(mesh.edges[e][0])]);
  return sum;
}

/// [-1, 1]^2 with a slit from its middle to the right: NIST 2.
Domain slit_square() {
  Domain domain;
  support::add_polygon(domain, {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}, 1);
  domain.points.insert(domain.points.end(), {{0.0, 0.0}, {1.0, 0.0}});
  domain.segments.push_back({4, 5, above, below});
  return domain;
}

/// The unit square with a star of three cracks, one of which ends on the boundary, and a chain of two.
Domain star_of_cracks() {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(),
                       {{0.4, 0.5}, {0.2, 0.6}, {0.5, 0.8}, {0.45, 0.0}, {0.7, 0.3}, {0.8, 0.5}, {0.7, 0.7}});
  for (const int end : {5, 6, 7}) domain.segments.push_back({4, end, above, below});
  domain.segments.push_back({8, 9, 5, 6});
  domain.segments.push_back({10, 9, 6, 5});
  return domain;
}

void check_valid(const Mesh& mesh, const Domain& domain, double area) {
  CHECK_NOTHROW(validate(mesh));
  CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
  CHECK(oracle::problems_of_cover(mesh, domain) == std::vector<std::string>{});
  CHECK(oracle::area_of(mesh) == Approx(area).epsilon(1e-12));
}

}  // namespace

TEST_CASE("open_cracks doubles all vertices of a crack but its tips", "[mesher][cracks]") {
  const Cracked closed = cracked_grid({{11, 12}, {12, 13}});
  const OpenedMesh opened = open_cracks(closed.mesh, closed.right_labels);
  CHECK(opened.mesh.num_vertices() == closed.mesh.num_vertices() + 1);
  CHECK(opened.mesh.num_edges() == closed.mesh.num_edges() + 2);
  CHECK(copies_of(opened.mesh, {0.5, 0.5}) == 2);
  CHECK(length_of(opened.mesh, above) == Approx(0.5).epsilon(1e-14));
  CHECK(length_of(opened.mesh, below) == Approx(0.5).epsilon(1e-14));
  CHECK(oracle::problems_of(opened.mesh) == std::vector<std::string>{});
  CHECK(opened.spread<Point>(closed.mesh.points) == opened.mesh.points);
}

TEST_CASE("each side of a crack has its label, with the domain to the left", "[mesher][cracks]") {
  const Cracked closed = cracked_grid({{11, 12}, {13, 12}});  // the second points back: its left side is below
  const Mesh open = open_cracks(closed.mesh, closed.right_labels).mesh;
  for (std::size_t e = 0; e < open.edges.size(); ++e) {
    if (open.labels[e] != above && open.labels[e] != below) continue;
    const Point& a = open.points[at(open.edges[e][0])];
    const Point& b = open.points[at(open.edges[e][1])];
    const bool in_first_half = a.x + b.x < 1.0;
    CHECK((b.x > a.x) == ((open.labels[e] == above) == in_first_half));
  }
}

TEST_CASE("vertices where cracks meet or reach the boundary split into their sectors", "[mesher][cracks]") {
  SECTION("four cracks in the middle") {
    const Cracked star = cracked_grid({{11, 12}, {12, 13}, {7, 12}, {12, 17}});
    const Mesh open = open_cracks(star.mesh, star.right_labels).mesh;
    CHECK(copies_of(open, {0.5, 0.5}) == 4);
    CHECK(oracle::problems_of(open) == std::vector<std::string>{});
  }
  SECTION("from side to side: two pieces") {
    const Cracked halves = cracked_grid({{10, 11}, {11, 12}, {12, 13}, {13, 14}});
    const Mesh open = open_cracks(halves.mesh, halves.right_labels).mesh;
    CHECK(open.num_vertices() == halves.mesh.num_vertices() + 5);
    CHECK(oracle::problems_of(open) == std::vector<std::string>{});
  }
  SECTION("a ring of cracks cuts out an island") {
    const Cracked ring = cracked_grid({{6, 7}, {7, 12}, {12, 11}, {11, 6}});
    const Mesh open = open_cracks(ring.mesh, ring.right_labels).mesh;
    CHECK(open.num_vertices() == ring.mesh.num_vertices() + 4);
    CHECK(oracle::problems_of(open) == std::vector<std::string>{});
  }
  SECTION("one edge from the boundary inwards opens at the boundary") {
    const Cracked notch = cracked_grid({{10, 11}});
    const Mesh open = open_cracks(notch.mesh, notch.right_labels).mesh;
    CHECK(copies_of(open, {0.0, 0.5}) == 2);
    CHECK(copies_of(open, {0.25, 0.5}) == 1);
  }
}

TEST_CASE("a crack of one edge between two tips cannot open", "[mesher][cracks][errors]") {
  const Cracked single = cracked_grid({{11, 12}});
  CHECK_THROWS_AS(open_cracks(single.mesh, single.right_labels), MeshingError);
}

TEST_CASE("close_cracks undoes open_cracks, whatever the cracks", "[mesher][cracks]") {
  std::mt19937 random(5);
  const Mesh grid = support::rectangle_mesh(4, 4);
  int num_opened = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<std::array<int, 2>> cracks;
    for (int v = 0; v < 25; ++v)
      for (const int w : {v + 1, v + 5}) {
        const bool is_inner = w == v + 1 ? v % 5 < 4 && v >= 5 && v < 20 : v % 5 > 0 && v % 5 < 4 && v < 20;
        if (!is_inner || random() % 3 != 0) continue;
        cracks.push_back(random() % 2 == 0 ? std::array{v, w} : std::array{w, v});
      }
    const Cracked closed = cracked_grid(cracks);
    OpenedMesh opened;
    try {
      opened = open_cracks(closed.mesh, closed.right_labels);
    } catch (const MeshingError&) {
      continue;
    }
    ++num_opened;
    CHECK(oracle::problems_of(opened.mesh) == std::vector<std::string>{});
    for (int v = 0; v < opened.mesh.num_vertices(); ++v) CHECK(num_fans(opened.mesh, v) == 1);
    CHECK(has_cracks(opened.mesh) == !cracks.empty());
    const ClosedMesh again = close_cracks(opened.mesh);
    CHECK(again.mesh.points == closed.mesh.points);
    CHECK(again.mesh.triangles == closed.mesh.triangles);
    CHECK(again.mesh.edges == closed.mesh.edges);
    CHECK(again.mesh.labels == closed.mesh.labels);
    CHECK(again.right_labels == closed.right_labels);
    CHECK(again.vertices == opened.sources);
  }
  CHECK(num_opened > 20);
  CHECK_FALSE(has_cracks(grid));
}

TEST_CASE("a slit domain is meshed with two sides along its slit", "[mesher][cracks]") {
  const Domain domain = slit_square();
  const double h = GENERATE(0.05, 0.4, 5.0);
  const GenerateResult result = generate(domain, ConstantField(Metric::isotropic(h)));
  check_valid(result.mesh, domain, 4.0);
  CHECK(copies_of(result.mesh, {0.0, 0.0}) == 1);
  CHECK(copies_of(result.mesh, {1.0, 0.0}) == 2);
  CHECK(result.metrics.size() == result.mesh.points.size());
  if (h < 0.1) CHECK(measure_quality(result.mesh, result.metrics).unit_edges > 0.99);
}

TEST_CASE("junctions and chains of cracks are meshed, and found again in the mesh", "[mesher][cracks]") {
  const Domain domain = star_of_cracks();
  const double h = GENERATE(0.03, 0.2, 5.0);
  const CallableField field([h](const Point& p) { return Metric::from_sizes(h, 2.0 * h, p.x); });
  const Mesh mesh = generate(domain, field).mesh;
  check_valid(mesh, domain, 1.0);
  CHECK(copies_of(mesh, {0.4, 0.5}) == 3);
  CHECK(copies_of(mesh, {0.8, 0.5}) == 2);
  CHECK(copies_of(mesh, {0.2, 0.6}) == 1);
  CHECK(length_of(mesh, 5) == Approx(length_of(mesh, 6)));
  const Domain found = domain_of(mesh);
  CHECK(found.segments.size() == clean(domain).domain.segments.size());
  check_valid(generate(found, field).mesh, domain, 1.0);
}

TEST_CASE("a crack alone gets a point in its middle, so that it opens", "[mesher][cracks]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.3, 0.5}, {0.7, 0.6}});
  domain.segments.push_back({4, 5, above, below});
  check_valid(generate(domain, ConstantField(Metric::isotropic(3.0))).mesh, domain, 1.0);
  check_valid(delaunay_mesh(domain).mesh, domain, 1.0);
}

TEST_CASE("so does one along a curve", "[mesher][cracks][curves]") {
  Domain domain;
  support::add_polygon(domain, {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, 1);
  domain.points.insert(domain.points.end(), {{1, 0}, {-1, 0}});
  domain.curves.push_back(circular_arc({0.0, 0.0}, 1.0, 0.0, M_PI));
  domain.segments.push_back({4, 5, 2, 3, false, 0});
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(3.0))).mesh;
  CHECK(std::ranges::count(mesh.labels, 2) == std::ranges::count(mesh.labels, 3));
  CHECK(std::ranges::count(mesh.labels, 2) >= 2);
  CHECK(has_cracks(mesh));
}

TEST_CASE("the tips of cracks are no repairs", "[mesher][cracks]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.3, 0.5}, {0.5, 0.5}});
  domain.segments.push_back({4, 5, above});
  CHECK(clean(domain).repairs.size() == 1);
  domain.segments.back().label_right = below;
  CHECK(clean(domain).repairs.empty());
}

TEST_CASE("a crack of one segment opens where another inner segment ends at it", "[mesher][cracks]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.3, 0.5}, {0.5, 0.5}, {0.7, 0.6}});
  domain.segments.push_back({4, 5, 7});
  domain.segments.push_back({5, 6, above, below});
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(3.0))).mesh;
  CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
  CHECK(has_cracks(mesh));
}

TEST_CASE("a crack of one segment opens where it ends inside another inner segment", "[mesher][cracks]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.3, 0.5}, {0.6, 0.5}, {0.6, 0.3}, {0.6, 0.8}});
  domain.segments.push_back({4, 5, above, below});
  domain.segments.push_back({6, 7, 7});
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(3.0))).mesh;
  CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
  CHECK(has_cracks(mesh));
}

TEST_CASE("the next mesh of a domain with cracks starts from the one before", "[mesher][cracks]") {
  const Domain domain = slit_square();
  const ConstantField field(Metric::isotropic(0.1));
  const Mesh first = generate(domain, field).mesh;
  const BackgroundMesh background(first, std::vector<Metric>(first.points.size(), Metric::isotropic(0.1)));
  const GenerateResult second = generate(domain, background, {}, first);
  CHECK(second.report.start == Start::PreviousMesh);
  check_valid(second.mesh, domain, 4.0);
  CHECK(second.mesh.num_vertices() == Approx(first.num_vertices()).epsilon(0.03));
}

TEST_CASE("a background mesh answers on each side of a crack with that side's metric", "[mesher][cracks]") {
  const Mesh mesh = generate(slit_square(), ConstantField(Metric::isotropic(0.1))).mesh;
  std::vector<double> height(mesh.points.size(), 0.0);  // of the triangles at each vertex
  for (const auto& t : mesh.triangles)
    for (const int v : t)
      for (const int w : t) height[at(v)] += mesh.points[at(w)].y;
  std::vector<Metric> metrics;
  for (std::size_t v = 0; v < height.size(); ++v) {
    const bool is_above = mesh.points[v].x > 0.0 && height[v] > 0.0;
    metrics.push_back(is_above ? Metric::from_sizes(0.1, 0.2, 0.0) : Metric::from_sizes(0.2, 0.1, 0.0));
  }
  const BackgroundMesh background(mesh, metrics);
  // The size across the crack at p, looked up on the way from the far end of the other side.
  const auto size_across = [&background](const Point& p) {
    MetricHint hint = -1;
    background.at({0.5, p.y > 0.0 ? -0.9 : 0.9}, hint);
    return 1.0 / background.at(p, hint).length({0.0, 1.0});
  };
  CHECK(size_across({0.6, 0.2}) == Approx(0.2));
  CHECK(size_across({0.6, -0.2}) == Approx(0.1));
  SECTION("and on the crack with the intersection") {
    for (const double y : {1e-13, -1e-13}) CHECK(size_across({0.6, y}) == Approx(0.1));
    CHECK(1.0 / background.at({0.6, 0.0}).length({1.0, 0.0}) == Approx(0.1));
  }
}

TEST_CASE("the tip of a crack is no sharp corner", "[mesher][cracks]") {
  const Mesh mesh = generate(slit_square(), ConstantField(Metric::isotropic(0.2))).mesh;
  std::vector<Metric> metrics(mesh.points.size(), Metric::isotropic(0.2));
  const auto tip = std::find(mesh.points.begin(), mesh.points.end(), Point{0.0, 0.0}) - mesh.points.begin();
  metrics[static_cast<std::size_t>(tip)] = Metric::from_sizes(1e-4, 0.2, 0.0);  // makes its triangles the worst
  const MeshQuality quality = measure_quality(mesh, metrics);
  CHECK(quality.quality_min_away_from_corners == quality.quality_min);
}

TEST_CASE("doubled vertices survive files", "[mesher][cracks][io]") {
  const support::TemporaryFolder folder;
  const Mesh mesh = generate(star_of_cracks(), ConstantField(Metric::isotropic(0.13))).mesh;
  for (const char* name : {"a.mesh", "b.meshb", "c.msh", "d.node"}) {
    INFO(name);
    write_mesh_file(folder / name, mesh);
    const Mesh read = read_valid_mesh(folder / name);
    CHECK(read.points == mesh.points);
    CHECK(read.triangles == mesh.triangles);
    CHECK(length_of(read, above) == Approx(length_of(mesh, above)).epsilon(1e-14));
    CHECK(length_of(read, below) == Approx(length_of(mesh, below)).epsilon(1e-14));
  }
  CHECK_THROWS_AS(write_mesh_file(folder / "e.poly", mesh), FileError);
}

TEST_CASE("a crack that is required to stay one edge is refused between free ends, and taken where it opens",
          "[mesher][cracks][required][errors]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.3, 0.5}, {0.7, 0.6}});
  domain.segments.push_back({4, 5, above, below, true});
  CHECK_THROWS_WITH(clean(domain), Catch::Contains("segment 4") && Catch::Contains("cannot open"));
  domain.points[4] = {0.0, 0.5};  // on the boundary
  const CleanDomain cleaned = clean(domain);
  CHECK(std::ranges::count_if(cleaned.domain.segments, [](const Segment& s) { return s.required; }) == 1);
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(0.2))).mesh;
  CHECK(std::ranges::count(mesh.labels, above) == 1);
  CHECK(std::ranges::count(mesh.labels, below) == 1);
}
