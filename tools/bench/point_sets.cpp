#include "tools/bench/point_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <random>
#include <span>
#include <utility>

namespace parmesan::bench {
namespace {

using Engine = std::mt19937_64;

std::vector<Point> random_points(int n, Engine& engine) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Point> points(static_cast<std::size_t>(n));
  for (Point& p : points) p = {uniform(engine), uniform(engine)};
  return points;
}

std::vector<Point> grid_points(int n, Engine& engine) {
  const int side = static_cast<int>(std::lround(std::sqrt(n)));
  std::vector<Point> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) points.push_back({static_cast<double>(i) / side, static_cast<double>(j) / side});
  std::ranges::shuffle(points, engine);
  return points;
}

std::vector<Point> circle_points(int n, Engine& engine) {
  std::uniform_real_distribution<double> uniform(0.0, 2.0 * std::numbers::pi);
  std::vector<Point> points(static_cast<std::size_t>(n));
  for (Point& p : points) {
    const double angle = uniform(engine);
    p = {std::cos(angle), std::sin(angle)};
  }
  return points;
}

std::vector<Point> clustered_points(int n, Engine& engine) {
  const std::vector<Point> centers = random_points(1000, engine);
  std::uniform_int_distribution<std::size_t> pick(0, centers.size() - 1);
  std::normal_distribution<double> normal(0.0, 1e-4);
  std::vector<Point> points(static_cast<std::size_t>(n));
  for (Point& p : points) p = centers[pick(engine)] + Vector{normal(engine), normal(engine)};
  return points;
}

/// Halves the indices at their median in x, then y, and so on; equal coordinates by the other one, so
/// that the halves' hulls are disjoint. Adds a segment between two points of each leaf.
void add_segments(Domain& domain, std::span<int> indices, bool by_x) {
  const auto at = [&](int i) -> const Point& { return domain.points[static_cast<std::size_t>(i)]; };
  if (indices.size() <= 16) {
    const auto [first, last] = std::ranges::minmax(indices);
    if (indices.size() > 1 && at(first) != at(last)) domain.segments.push_back({first, last, 0});
    return;
  }
  const auto key = [&](int i) { return by_x ? std::pair(at(i).x, at(i).y) : std::pair(at(i).y, at(i).x); };
  const std::size_t half = indices.size() / 2;
  std::ranges::nth_element(indices, indices.begin() + static_cast<std::ptrdiff_t>(half), {}, key);
  add_segments(domain, indices.first(half), !by_x);
  add_segments(domain, indices.subspan(half), !by_x);
}

}  // namespace

std::vector<PointSet> point_sets(int n) {
  Engine engine(1);
  return {{"random", random_points(n, engine)},
          {"grid", grid_points(n, engine)},
          {"circle", circle_points(n, engine)},
          {"clusters", clustered_points(n, engine)}};
}

Domain with_segments(const std::vector<Point>& points) {
  Domain domain;
  domain.points = points;
  std::vector<int> indices(points.size());
  std::iota(indices.begin(), indices.end(), 0);
  add_segments(domain, indices, true);
  const int n = static_cast<int>(points.size());
  for (const Point& corner : {Point{-3, -3}, Point{3, -3}, Point{3, 3}, Point{-3, 3}}) domain.points.push_back(corner);
  for (int i = 0; i < 4; ++i) domain.segments.push_back({n + i, n + (i + 1) % 4, 1});
  return domain;
}

}  // namespace parmesan::bench
