#include "mesher/geometry/domain_of_mesh.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "mesher/geometry/clean.h"
#include "tests/oracle/domain_cover.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

/// An n x n rectangle mesh of the unit square without the cells for which is_void holds; all
/// boundary edges that are not the square's get the label 9.
template <class F>
Mesh perforated(int n, F is_void) {
  const Mesh full = support::rectangle_mesh(n, n);
  Mesh mesh = full;
  mesh.triangles.clear();
  std::vector<int> renumbered(full.points.size(), -1);
  std::set<std::array<int, 2>> sides;
  for (std::size_t t = 0; t < full.triangles.size(); ++t) {
    const int cell = static_cast<int>(t / 2);
    if (is_void(cell % n, cell / n)) continue;
    mesh.triangles.push_back(full.triangles[t]);
    for (std::size_t k = 0; k < 3; ++k) sides.insert({full.triangles[t][k], full.triangles[t][(k + 1) % 3]});
  }
  mesh.regions.assign(mesh.triangles.size(), 0);
  for (const auto& [a, b] : sides) {
    const std::array<int, 2> side{a, b};
    if (sides.count({b, a}) > 0 || std::count(full.edges.begin(), full.edges.end(), side) > 0) continue;
    mesh.edges.push_back(side);
    mesh.labels.push_back(9);
  }
  mesh.points.clear();
  const auto number = [&mesh, &full, &renumbered](int v) {
    int& id = renumbered[static_cast<std::size_t>(v)];
    if (id < 0) {
      id = mesh.num_vertices();
      mesh.points.push_back(full.points[static_cast<std::size_t>(v)]);
    }
    return id;
  };
  for (auto& t : mesh.triangles) t = {number(t[0]), number(t[1]), number(t[2])};
  for (auto& e : mesh.edges) e = {number(e[0]), number(e[1])};
  return mesh;
}

bool in_triangle(const Mesh& mesh, const std::array<int, 3>& t, const Point& p) {
  const auto at = [&mesh](int v) { return mesh.points[static_cast<std::size_t>(v)]; };
  return doubled_area(at(t[0]), at(t[1]), p) >= 0 && doubled_area(at(t[1]), at(t[2]), p) >= 0 &&
         doubled_area(at(t[2]), at(t[0]), p) >= 0;
}

int num_triangles_at(const Mesh& mesh, const Point& p) {
  return static_cast<int>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                        [&mesh, &p](const auto& t) { return in_triangle(mesh, t, p); }));
}

/// (x, y) of the cell of an n x n grid of the unit square.
std::set<std::pair<int, int>> cells_of(const std::vector<Point>& points, int n) {
  std::set<std::pair<int, int>> cells;
  for (const Point& p : points) cells.emplace(static_cast<int>(std::floor(n * p.x)), static_cast<int>(n * p.y));
  return cells;
}

Mesh rotated(Mesh mesh, double angle) {
  return support::mapped(std::move(mesh), [angle](const Point& p) {
    return Point{std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
  });
}

}  // namespace

TEST_CASE("a loop without corners is kept edge by edge", "[mesher][domain]") {
  // Micrometres at coordinates of a map: a vertex is off the line of its neighbours by less than rounding.
  constexpr int n = 64;
  constexpr double full_turn = 6.283185307179586;
  const Point centre{500'000.0, 5'400'000.0};
  Mesh disc;
  disc.points.push_back(centre);
  for (int i = 0; i < n; ++i) {
    const double angle = full_turn * i / n;
    disc.points.push_back(centre + 1.5e-6 * Vector{std::cos(angle), std::sin(angle)});
    disc.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
    disc.edges.push_back({1 + i, 1 + (i + 1) % n});
  }
  disc.regions.assign(n, 0);
  disc.labels.assign(n, 3);
  SECTION("nor any that is required") {}
  SECTION("but for one") { disc.required.vertices = {7}; }
  const Domain domain = domain_of(disc);
  CHECK(domain.segments.size() == n);
  for (const Segment& s : domain.segments) CHECK((s.a != s.b && s.label == 3));
}

TEST_CASE("domain_of a square's mesh is the square", "[mesher][domain]") {
  const Domain domain = domain_of(support::rectangle_mesh(6, 4));
  CHECK(domain.points == std::vector<Point>{{0, 0}, {1, 0}, {0, 1}, {1, 1}});
  REQUIRE(domain.segments.size() == 4);
  std::set<std::array<int, 3>> found;
  for (const Segment& s : domain.segments) found.insert({s.a, s.b, s.label});
  CHECK(found == std::set<std::array<int, 3>>{{0, 1, 1}, {1, 3, 2}, {3, 2, 3}, {2, 0, 4}});
  CHECK(domain.holes.empty());
  CHECK(domain.regions.empty());
  CHECK(domain.label_names.at(support::Top) == "top");
}

TEST_CASE("domain_of joins edges that are straight up to rounding", "[mesher][domain]") {
  for (int i = 1; i < 20; ++i) {
    const Mesh mesh = rotated(support::rectangle_mesh(15, 15), 0.3 * i);
    const Domain domain = domain_of(mesh);
    CHECK(domain.points.size() == 4);
    CHECK(domain.segments.size() == 4);
    CHECK(oracle::problems_of_cover(mesh, domain, 1e-14).empty());
  }
}

TEST_CASE("domain_of keeps every vertex of a boundary that bends slightly", "[mesher][domain]") {
  const Mesh mesh = support::mapped(support::rectangle_mesh(50, 2), [](const Point& p) {
    return Point{p.x, p.y + 1e-9 * p.x * (1.0 - p.x)};
  });
  // 2 x 51 vertices at bottom and top; the sides stay straight.
  CHECK(domain_of(mesh).points.size() == 102);
}

TEST_CASE("domain_of makes a corner where the label changes", "[mesher][domain]") {
  Mesh mesh = support::rectangle_mesh(4, 4);
  mesh.labels[1] = 7;  // the second edge at the bottom
  const Domain domain = domain_of(mesh);
  CHECK(domain.segments.size() == 6);
  CHECK(domain.points.size() == 6);
  CHECK(oracle::problems_of_cover(mesh, domain).empty());
}

TEST_CASE("domain_of puts one seed into each hole and none elsewhere", "[mesher][domain]") {
  const Mesh mesh = perforated(9, [](int x, int y) {
    return (x == 1 && y == 1) || (x == 6 && y >= 2 && y <= 4) || (y == 7 && x >= 1 && x <= 7);
  });
  REQUIRE(oracle::problems_of(mesh).empty());
  const Domain domain = domain_of(mesh);
  CHECK(domain.holes.size() == 3);
  for (const Point& seed : domain.holes) CHECK(num_triangles_at(mesh, seed) == 0);
  std::set<int> columns;
  for (const auto& [x, y] : cells_of(domain.holes, 9)) columns.insert(y == 7 ? 7 : x);
  CHECK(columns == std::set<int>{1, 6, 7});
}

TEST_CASE("domain_of tells holes that touch at a vertex apart", "[mesher][domain]") {
  const Mesh mesh = perforated(4, [](int x, int y) { return (x == 1 && y == 1) || (x == 2 && y == 2); });
  REQUIRE(oracle::problems_of(mesh).empty());
  CHECK(cells_of(domain_of(mesh).holes, 4) == std::set<std::pair<int, int>>{{1, 1}, {2, 2}});
}

TEST_CASE("domain_of puts one seed into a hole with an island", "[mesher][domain]") {
  const Mesh mesh =
      perforated(7, [](int x, int y) { return x >= 1 && x <= 5 && y >= 1 && y <= 5 && !(x == 3 && y == 3); });
  REQUIRE(oracle::problems_of(mesh).empty());
  const Domain domain = domain_of(mesh);
  REQUIRE(domain.holes.size() == 1);
  CHECK(num_triangles_at(mesh, domain.holes[0]) == 0);
  CHECK(domain.holes[0].x > 1.0 / 7);
  CHECK(domain.holes[0].x < 6.0 / 7);
  CHECK(domain.points.size() == 12);
}

TEST_CASE("domain_of keeps regions and their unlabelled border", "[mesher][domain]") {
  Mesh mesh = support::rectangle_mesh(4, 4);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    mesh.regions[t] = mesh.points[static_cast<std::size_t>(mesh.triangles[t][0])].x < 0.4 ? 5 : 0;
  }
  const Domain domain = domain_of(mesh);
  REQUIRE(domain.regions.size() == 1);
  CHECK(domain.regions[0].region == 5);
  CHECK(domain.regions[0].point.x < 0.5);
  CHECK(std::count_if(domain.segments.begin(), domain.segments.end(), [](const Segment& s) { return s.label == 0; }) ==
        1);
  CHECK(domain.segments.size() == 7);
}

TEST_CASE("domain_of keeps inner constraints as segments", "[mesher][domain]") {
  Mesh mesh = support::rectangle_mesh(4, 4);
  for (int i = 1; i < 3; ++i) {
    mesh.edges.push_back({10 + i, 11 + i});  // y = 0.5 from x = 0.25 to x = 0.75
    mesh.labels.push_back(6);
  }
  const Domain domain = domain_of(mesh);
  REQUIRE(domain.segments.size() == 5);
  const auto inner =
      std::find_if(domain.segments.begin(), domain.segments.end(), [](const Segment& s) { return s.label == 6; });
  REQUIRE(inner != domain.segments.end());
  CHECK(domain.points[static_cast<std::size_t>(inner->a)] == Point{0.25, 0.5});
  CHECK(domain.points[static_cast<std::size_t>(inner->b)] == Point{0.75, 0.5});
}

TEST_CASE("the domain of a mesh is clean", "[mesher][domain]") {
  const Mesh mesh = perforated(8, [](int x, int y) { return x % 7 > 0 && y % 7 > 0 && (x + 2 * y) % 5 == 0; });
  REQUIRE(oracle::problems_of(mesh).empty());
  const Domain domain = domain_of(mesh);
  const CleanDomain cleaned = clean(domain);
  CHECK(cleaned.repairs.empty());
  CHECK(cleaned.domain.segments.size() == domain.segments.size());
  CHECK(oracle::problems_of_cover(mesh, domain).empty());
}

namespace {

/// The unit square in two halves with vertices of their own where they meet. label: of the sides there, none for 0.
Mesh halves(int label_left, int label_right) {
  Mesh mesh = support::rectangle_mesh(2, 4, {0, 0}, {0.5, 1});
  const Mesh right = support::rectangle_mesh(2, 4, {0.5, 0}, {1, 1});
  const int n = mesh.num_vertices();
  mesh.points.insert(mesh.points.end(), right.points.begin(), right.points.end());
  for (const auto& [a, b, c] : right.triangles) mesh.triangles.push_back({a + n, b + n, c + n});
  mesh.regions.assign(mesh.triangles.size(), 0);
  for (const auto& [a, b] : right.edges) mesh.edges.push_back({a + n, b + n});
  mesh.labels.assign(mesh.edges.size(), 1);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto& [a, b] = mesh.edges[e];
    const auto x = [&mesh](int v) { return mesh.points[static_cast<std::size_t>(v)].x; };
    if (x(a) == 0.5 && x(b) == 0.5) mesh.labels[e] = a < n ? label_left : label_right;
  }
  return mesh;
}

int num_segments_between(const Domain& domain, double x) {
  return static_cast<int>(std::ranges::count_if(domain.segments, [&](const Segment& s) {
    const auto is_there = [&](int p) { return domain.points[static_cast<std::size_t>(p)].x == x; };
    return is_there(s.a) && is_there(s.b);
  }));
}

}  // namespace

TEST_CASE("domain_of joins parts with doubled vertices where neither side has a label, and says so",
          "[mesher][domain]") {
  const Domain domain = domain_of(halves(0, 0));
  CHECK(num_segments_between(domain, 0.5) == 0);
  CHECK(domain.holes.empty());
  REQUIRE(domain.notes.size() == 1);
  CHECK_THAT(domain.notes.front(),
             Catch::Contains("4 pairs of sides without a label, the first from (0.5, 0) to (0.5, 0.25)") &&
                 Catch::Contains("joined"));
  CHECK(clean(domain).repairs == domain.notes);
  CHECK(domain_of(support::rectangle_mesh(2, 2)).notes.empty());
}

TEST_CASE("domain_of keeps the border of regions that it joins", "[mesher][domain]") {
  Mesh mesh = halves(0, 0);
  for (std::size_t t = mesh.regions.size() / 2; t < mesh.regions.size(); ++t) mesh.regions[t] = 1;
  const Domain domain = domain_of(mesh);
  REQUIRE(num_segments_between(domain, 0.5) == 1);
  for (const Segment& s : domain.segments) CHECK_FALSE(s.label_right.has_value());
  CHECK(domain.regions.size() == 1);
}

TEST_CASE("domain_of takes doubled sides for a crack where one of them has a label", "[mesher][domain]") {
  for (const auto& [left, right] : {std::pair{7, 8}, std::pair{7, 0}, std::pair{0, 8}, std::pair{7, 7}}) {
    const Domain domain = domain_of(halves(left, right));
    CHECK(num_segments_between(domain, 0.5) == 1);
    const auto crack =
        std::ranges::find_if(domain.segments, [](const Segment& s) { return s.label_right.has_value(); });
    REQUIRE(crack != domain.segments.end());
    CHECK(std::set{crack->label, *crack->label_right} == std::set{left, right});
    CHECK(domain.notes.empty());
  }
}
