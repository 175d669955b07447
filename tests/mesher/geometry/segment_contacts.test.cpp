#include "mesher/geometry/segment_contacts.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <vector>

#include "mesher/errors.h"
#include "tests/oracle/exact_sign.h"

using namespace parmesan;

namespace {

struct Graph {
  std::vector<Point> points;
  std::vector<Segment> segments;
};

/// Segments of up to the given reach between points of a small integer grid: many touch and overlap.
Graph grid_graph(int num_segments, int size, int reach, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_int_distribution<int> pick(0, size - 1), step(-reach, reach);
  Graph graph;
  for (int i = 0; i < size * size; ++i) graph.points.push_back({0.1 * (i % size), 0.1 * (i / size)});
  while (static_cast<int>(graph.segments.size()) < num_segments) {
    const int x = pick(engine), y = pick(engine), u = x + step(engine), v = y + step(engine);
    if (u < 0 || v < 0 || u >= size || v >= size || (u == x && v == y)) continue;
    graph.segments.push_back({y * size + x, v * size + u, 0});
  }
  return graph;
}

using Pairs = std::vector<std::array<int, 2>>;

struct Contacts {
  Pairs crossings;
  Pairs points_inside;
};

/// Every pair, by integer arithmetic.
Contacts by_brute_force(const Graph& graph) {
  Contacts contacts;
  const auto point = [&graph](int i) { return graph.points[static_cast<std::size_t>(i)]; };
  const int n = static_cast<int>(graph.segments.size());
  for (int s = 0; s < n; ++s) {
    const Segment& st = graph.segments[static_cast<std::size_t>(s)];
    const Point a = point(st.a), b = point(st.b);
    for (int p = 0; p < static_cast<int>(graph.points.size()); ++p) {
      const Point q = point(p);
      if (oracle::orientation(a, b, q) == 0 && dot(a - q, b - q) < 0.0) contacts.points_inside.push_back({s, p});
    }
    for (int t = s + 1; t < n; ++t) {
      const Segment& tt = graph.segments[static_cast<std::size_t>(t)];
      const Point c = point(tt.a), d = point(tt.b);
      if (oracle::orientation(a, b, c) * oracle::orientation(a, b, d) < 0 &&
          oracle::orientation(c, d, a) * oracle::orientation(c, d, b) < 0) {
        contacts.crossings.push_back({s, t});
      }
    }
  }
  return contacts;
}

double seconds_for(const Graph& graph) {
  const auto start = std::chrono::steady_clock::now();
  points_inside_segments(graph.points, graph.segments);
  segment_crossings(graph.points, graph.segments);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("points_inside_segments and segment_crossings find what brute force finds", "[mesher][segment_contacts]") {
  for (unsigned seed = 0; seed < 16; ++seed) {
    const Graph graph = grid_graph(60, 20, 1 + static_cast<int>(seed % 2), seed);
    const Contacts expected = by_brute_force(graph);
    CHECK(points_inside_segments(graph.points, graph.segments) == expected.points_inside);
    CHECK(segment_crossings(graph.points, graph.segments) == expected.crossings);
  }
}

TEST_CASE("segment_crossings finds the crossings of long segments that brute force finds",
          "[mesher][segment_contacts]") {
  for (unsigned seed = 0; seed < 16; ++seed) {
    const Graph graph = grid_graph(40, 30, 3 + static_cast<int>(seed % 9), seed);
    CHECK(segment_crossings(graph.points, graph.segments) == by_brute_force(graph).crossings);
  }
}

TEST_CASE("evident_crossings are crossings, and all of them where it says so", "[mesher][segment_contacts]") {
  for (unsigned seed = 0; seed < 16; ++seed) {
    const Graph graph = grid_graph(40, 30, 3 + static_cast<int>(seed % 9), seed);
    const Pairs expected = by_brute_force(graph).crossings;
    const EvidentCrossings all = evident_crossings(graph.points, graph.segments, 1000);
    CHECK(std::includes(expected.begin(), expected.end(), all.pairs.begin(), all.pairs.end()));
    if (all.are_all) CHECK(all.pairs == expected);
    const EvidentCrossings some = evident_crossings(graph.points, graph.segments, 2);
    CHECK(std::includes(expected.begin(), expected.end(), some.pairs.begin(), some.pairs.end()));
    CHECK((some.are_all || some.pairs.size() >= 2));
  }
}

TEST_CASE("evident_crossings ends soon among segments that overlap", "[mesher][segment_contacts]") {
  Graph stack;
  for (int i = 0; i < 1000; ++i) {
    stack.points.insert(stack.points.end(), {{0.1 + 1e-4 * i, 0.1 + 1e-4 * i}, {1.0 - 1e-4 * i, 1.0 - 1e-4 * i}});
    stack.segments.push_back({2 * i, 2 * i + 1, 0});
  }
  const std::clock_t start = std::clock();
  const EvidentCrossings found = evident_crossings(stack.points, stack.segments, 1000);
  CHECK(std::clock() - start < 5 * CLOCKS_PER_SEC);
  CHECK_FALSE(found.are_all);
}

TEST_CASE("segment_crossings finds the single crossing of two long segments among many", "[mesher][segment_contacts]") {
  Graph graph;
  const int n = 800;
  for (int i = 0; i < n; ++i) {  // nested diagonals that do not meet
    graph.points.push_back({0.0, i * 1e-3});
    graph.points.push_back({10.0, 7.0 + i * 1e-3});
    graph.segments.push_back({2 * i, 2 * i + 1, 0});
  }
  CHECK(segment_crossings(graph.points, graph.segments).empty());
  std::swap(graph.segments[234].b, graph.segments[235].b);
  CHECK(segment_crossings(graph.points, graph.segments) == Pairs{{234, 235}});
}

TEST_CASE("the search for contacts stays fast on hard inputs of 60000 segments", "[mesher][segment_contacts][slow]") {
  Graph fan, cluster;
  fan.points.push_back({0, 0});
  cluster.points.push_back({1e3, 1e3});
  const int n = 60'000;
  for (int i = 0; i < n; ++i) {
    const double angle = 1e-4 * i;
    fan.points.push_back({std::cos(angle), std::sin(angle)});
    if (i < 20'000) fan.segments.push_back({0, i + 1, 0});
    cluster.points.push_back({1e-6 * angle * std::cos(10 * angle), 1e-6 * angle * std::sin(10 * angle)});
    if (i > 0) cluster.segments.push_back({i, i + 1, 0});
  }
  CHECK(seconds_for(fan) < 10.0);
  CHECK(seconds_for(cluster) < 10.0);
}

TEST_CASE("crossing_point is where two lines meet", "[mesher][segment_contacts]") {
  CHECK(crossing_point({0, 0}, {2, 2}, {0, 2}, {2, 0}) == Point{1, 1});
  const Point p = crossing_point({0, 0}, {4, 0}, {1, -1}, {1, 3});
  CHECK(p.x == Approx(1.0).epsilon(1e-15));
  CHECK(p.y == 0.0);
}
