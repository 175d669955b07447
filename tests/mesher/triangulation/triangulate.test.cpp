#include "mesher/triangulation/triangulate.h"

#include <catch2/catch.hpp>
#include <charconv>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "mesher/triangulation/carve.h"
#include "mesher/triangulation/check.h"
#include "tests/mesher/triangulation/sites.h"
#include "tests/support/shared.h"

namespace parmesan {
namespace {

/// The numbers of a text file; everything that is not a number ends the list.
std::vector<double> numbers_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  std::vector<double> numbers;
  std::string word;
  while (text >> word) {
    const char* first = word.data() + (word[0] == '+' ? 1 : 0);
    double x = 0.0;
    if (std::from_chars(first, word.data() + word.size(), x).ec != std::errc{}) break;
    numbers.push_back(x);
  }
  return numbers;
}

/// n, m, n points, m edges (the format of CDT's test files).
Domain points_and_edges(const std::string& path) {
  const std::vector<double> numbers = numbers_of(path);
  Domain d;
  if (numbers.size() < 2) return d;
  const auto n = static_cast<std::size_t>(numbers[0]);
  const auto m = static_cast<std::size_t>(numbers[1]);
  if (numbers.size() < 2 + 2 * n + 2 * m) return d;
  for (std::size_t i = 0; i < n; ++i) d.points.push_back({numbers[2 + 2 * i], numbers[3 + 2 * i]});
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t k = 2 + 2 * n + 2 * i;
    d.segments.push_back({static_cast<int>(numbers[k]), static_cast<int>(numbers[k + 1]), 0});
  }
  return d;
}

/// One closed polygon, a point per line (the format of poly2tri's test files); nothing if it has holes.
Domain polygon(const std::string& path) {
  const std::vector<double> numbers = numbers_of(path);
  std::ifstream file(path);
  if (std::string(std::istreambuf_iterator<char>(file), {}).find("HOLE") != std::string::npos) return {};
  Domain d;
  const int n = static_cast<int>(numbers.size() / 2);
  for (int i = 0; i < n; ++i) {
    d.points.push_back({numbers[static_cast<std::size_t>(2 * i)], numbers[static_cast<std::size_t>(2 * i + 1)]});
    d.segments.push_back({i, (i + 1) % n, 0});
  }
  return d;
}

/// A row of the reference table: triangles and area of the even-odd domain, by another program.
struct Reference {
  std::string kind;
  int triangles = 0;
  double area = 0.0;
};

std::map<std::string, Reference> references(const std::string& shared) {
  std::map<std::string, Reference> result;
  std::ifstream file(shared + "/corpus/REFERENCE_CGAL.csv");
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::vector<std::string> cells;
    std::stringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells.size() < 6 || cells[4].empty() || cells[5].empty()) continue;
    Reference r{cells[1]};
    std::from_chars(cells[4].data(), cells[4].data() + cells[4].size(), r.triangles);
    std::from_chars(cells[5].data(), cells[5].data() + cells[5].size(), r.area);
    result[cells[0]] = r;
  }
  return result;
}

void compare(const Domain& domain, const Reference& reference) {
  const Triangulation t = triangulate(domain);
  for (const auto& v : check(t, {.is_delaunay = true})) FAIL_CHECK(v);
  if (missing_segments(t, domain).empty())
    for (const auto& v : check_constraints(t, domain)) FAIL_CHECK(v);
  CHECK(support::num_triangles(t) == reference.triangles);
  CHECK(0.5 * support::doubled_area_of(t) == Approx(reference.area).epsilon(1e-5));  // the table has six digits
}

}  // namespace

TEST_CASE("triangulate agrees with the reference on valid polygons of the corpus", "[mesher][triangulation]") {
  const auto shared = support::shared_dir();
  if (!shared) return;
  int compared = 0;
  for (const auto& [name, reference] : references(*shared)) {
    if (reference.kind != "valid-plc" || reference.triangles == 0) continue;
    const std::string path = *shared + "/corpus/" + name;
    Domain domain;
    if (name.ends_with(".dat") && name.starts_with("jhasse")) domain = polygon(path);
    if (name.ends_with(".txt") && name.starts_with("artem")) domain = points_and_edges(path);
    if (domain.segments.empty()) continue;
    domain.inside = Inside::EvenOdd;
    INFO(name);
    compare(domain, reference);
    ++compared;
  }
  CHECK(compared > 20);
}

TEST_CASE("triangulate keeps point indices as vertex ids and segment indices on edges", "[mesher][triangulation]") {
  Domain d;
  d.points = {{9, 9}, {0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}};
  d.segments = {{1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 1, 0}};
  const Triangulation t = triangulate(d);
  CHECK(check(t, {.is_delaunay = true}).empty());
  CHECK(check_constraints(t, d).empty());
  CHECK(!t.has_vertex(0));
  for (VertexId v = 1; v < 6; ++v) CHECK(t.point(v) == d.points[static_cast<std::size_t>(v)]);
}

TEST_CASE("triangulate takes a duplicate for the first point at its place", "[mesher][triangulation]") {
  Domain d;
  d.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {4, 4}};
  d.segments = {{0, 1, 0}, {1, 4, 0}, {2, 3, 0}, {3, 0, 0}};
  const Triangulation t = triangulate(d);
  CHECK(support::num_triangles(t) == 2);
  CHECK(!t.has_vertex(4));
}

}  // namespace parmesan
