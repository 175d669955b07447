#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "mesher/geometry/point.h"
#include "mesher/geometry/predicates.h"
#include "mesher/triangulation/delaunay.h"
#include "mesher/triangulation/triangulation.h"

namespace parmesan::support {

inline std::vector<Point> random_points(int n, unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double x = std::ldexp(static_cast<double>(engine()), -32);
    points.push_back({x, std::ldexp(static_cast<double>(engine()), -32)});
  }
  return points;
}

/// Columns x rows integer points: every cell has four cocircular corners, every side collinear points.
inline std::vector<Point> grid_points(int columns, int rows) {
  std::vector<Point> points;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  return points;
}

/// Nearly, and many exactly, cocircular points, and the centre.
inline std::vector<Point> circle_points(int n) {
  std::vector<Point> points = {{0.0, 0.0}};
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

/// The 36 integer points on the circle of radius 65 round the origin, exactly cocircular.
inline std::vector<Point> integer_circle_points() {
  std::vector<Point> points;
  for (int x = -65; x <= 65; ++x)
    for (int y = -65; y <= 65; ++y)
      if (x * x + y * y == 65 * 65) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  return points;
}

/// Clusters whose inner distances are 2^-40 of their mutual ones.
inline std::vector<Point> clustered_points(int clusters, int per_cluster, unsigned seed) {
  std::vector<Point> points;
  const std::vector<Point> centers = random_points(clusters, seed);
  for (int k = 0; k < clusters; ++k)
    for (const Point& p : random_points(per_cluster, seed + 1 + static_cast<unsigned>(k)))
      points.push_back(centers[static_cast<std::size_t>(k)] + std::ldexp(1.0, -40) * p);
  return points;
}

inline int num_triangles(const Triangulation& t) {
  int sides = 0;
  for (std::int32_t i = 0; i < 4 * t.size(); i += 2)
    if (t.is_alive(i / 4) && t.is_inside_left({i})) ++sides;
  return sides / 3;
}

inline std::int32_t num_edges(const Triangulation& t) {
  std::int32_t edges = 0;
  for (std::int32_t q = 0; q < t.size(); ++q) edges += t.is_alive(q) ? 1 : 0;
  return edges;
}

/// Twice the area that the triangles cover.
inline double doubled_area_of(const Triangulation& t) {
  double sum = 0.0;
  for (std::int32_t i = 0; i < 4 * t.size(); i += 2) {
    const EdgeId e{i};
    if (!t.is_alive(i / 4) || !t.is_inside_left(e)) continue;
    sum += doubled_area(t.point(t.org(e)), t.point(t.dest(e)), t.point(t.dest(t.lnext(e)))) / 3.0;
  }
  return sum;
}

/// Is the quadrilateral round the free inside edge e strictly convex?
inline bool is_convex(const Triangulation& t, EdgeId e) {
  const Point& c = t.point(t.dest(t.onext(e)));
  const Point& d = t.point(t.dest(t.oprev(e)));
  return orient2d(d, c, t.point(t.org(e))) > 0.0 && orient2d(c, d, t.point(t.dest(e))) > 0.0;
}

/// Tries to flip edges drawn at random: a valid triangulation far from Delaunay.
inline void flip_at_random(Triangulation& t, int tries, unsigned seed) {
  std::mt19937 engine(seed);
  for (int k = 0; k < tries; ++k) {
    const EdgeId e{static_cast<std::int32_t>(engine() % static_cast<unsigned>(t.size())) * 4};
    if (t.is_alive(undirected(e)) && has_diagonal(t, e) && is_convex(t, e)) t.flip(e);
  }
}

}  // namespace parmesan::support
