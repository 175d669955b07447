#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan::support {

/// Labels of the sides of the rectangles made here.
enum SideLabel { Bottom = 1, Right = 2, Top = 3, Left = 4 };

/// For each edge of a mesh whose labels are these, the index of its segment in unit_square().
inline std::vector<int> segments_of(const Mesh& mesh) {
  std::vector<int> segments;
  for (const int label : mesh.labels) segments.push_back(label - 1);
  return segments;
}

/// nx by ny cells on [x0, x1] x [y0, y1], two triangles each.
///
///       Top 3
///     +-------+      vertex (i, j) has index j (nx + 1) + i;
///     | / | / |      diagonals alternate when `alternate` is set.
///     +-------+
///      Bottom 1
inline Mesh rectangle_mesh(int nx, int ny, const Point& min = {0, 0}, const Point& max = {1, 1},
                           bool alternate = false) {
  Mesh mesh;
  mesh.label_names = {{Bottom, "bottom"}, {Right, "right"}, {Top, "top"}, {Left, "left"}};
  const auto id = [nx](int i, int j) { return j * (nx + 1) + i; };
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) {
      mesh.points.push_back({min.x + (max.x - min.x) * i / nx, min.y + (max.y - min.y) * j / ny});
    }
  }
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
      if (alternate && (i + j) % 2 == 1) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {b, c, d}});
      } else {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
      }
    }
  }
  mesh.regions.assign(mesh.triangles.size(), 0);
  const auto add = [&mesh](int from, int to, int label) {
    mesh.edges.push_back({from, to});
    mesh.labels.push_back(label);
  };
  for (int i = 0; i < nx; ++i) add(id(i, 0), id(i + 1, 0), Bottom);
  for (int j = 0; j < ny; ++j) add(id(nx, j), id(nx, j + 1), Right);
  for (int i = nx; i > 0; --i) add(id(i, ny), id(i - 1, ny), Top);
  for (int j = ny; j > 0; --j) add(id(0, j), id(0, j - 1), Left);
  return mesh;
}

/// The mesh with its points mapped; the map must keep triangles counter-clockwise.
inline Mesh mapped(Mesh mesh, const std::function<Point(const Point&)>& map) {
  for (Point& p : mesh.points) p = map(p);
  return mesh;
}

/// A rectangle mesh of the unit square bent smoothly, so that convergence orders are kept.
inline Mesh bent_square(int n) {
  return mapped(rectangle_mesh(n, n, {0, 0}, {1, 1}, true), [](const Point& p) {
    const double s = 0.06 * std::sin(2 * M_PI * p.x) * std::sin(2 * M_PI * p.y);
    return Point{p.x + s, p.y - 0.8 * s};
  });
}

/// A rectangle mesh of the unit square whose cells are 3 to 50 times as wide as they are high at the bottom, 1.1 times
/// at the top, on lines that are bent.
inline Mesh stretched_square(int n) {
  return mapped(rectangle_mesh(n / 4, 4 * n, {0, 0}, {1, 1}, true), [](const Point& p) {
    const double y = std::expm1(2.0 * p.y) / std::expm1(2.0);
    return Point{p.x + 0.05 * std::sin(2 * M_PI * p.x) * std::sin(M_PI * y), y};
  });
}

/// A rectangle mesh of the unit square with its inner vertices moved at random by up to `amount`
/// of a cell; amounts up to 0.24 keep all triangles positive.
inline Mesh random_square(int n, double amount, unsigned seed) {
  Mesh mesh = rectangle_mesh(n, n, {0, 0}, {1, 1}, true);
  std::mt19937 engine(seed);
  const auto draw = [&engine] { return 2.0 * static_cast<double>(engine()) / 4294967295.0 - 1.0; };
  for (Point& p : mesh.points) {
    const bool inside = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1;
    const double dx = draw(), dy = draw();
    if (inside) p = {p.x + amount / n * dx, p.y + amount / n * dy};
  }
  return mesh;
}

/// random_square(n, 0.24, seed), n even, with an interface along x = 1/2: edges of this label, region 1 to their left
/// and 2 to their right.
inline Mesh two_regions(int n, int label, unsigned seed) {
  Mesh mesh = random_square(n, 0.24, seed);
  const auto id = [n](int j) { return j * (n + 1) + n / 2; };
  for (int j = 0; j <= n; ++j) mesh.points[static_cast<std::size_t>(id(j))].x = 0.5;
  for (int j = 0; j < n; ++j) {
    mesh.edges.push_back({id(j), id(j + 1)});
    mesh.labels.push_back(label);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.regions[t] = static_cast<int>(t / 2) % n < n / 2 ? 1 : 2;
  return mesh;
}

/// The square (-1, 1)^2 without its quarter below and to the right, n cells on each half side; all edges are Bottom.
inline Mesh l_shape_mesh(int n) {
  const Mesh square = rectangle_mesh(2 * n, 2 * n, {-1, -1}, {1, 1});
  Mesh mesh;
  mesh.label_names = square.label_names;
  std::vector<int> number(square.points.size(), -1);
  std::map<std::pair<int, int>, int> count;  // of triangles on the directed side
  for (std::size_t t = 0; t < square.triangles.size(); ++t) {
    const std::size_t cell = t / 2;
    const auto cells = static_cast<std::size_t>(n);
    if (cell % (2 * cells) >= cells && cell / (2 * cells) < cells) continue;
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      int& v = number[static_cast<std::size_t>(square.triangles[t][k])];
      if (v < 0) {
        v = mesh.num_vertices();
        mesh.points.push_back(square.points[static_cast<std::size_t>(square.triangles[t][k])]);
      }
      corners[k] = v;
    }
    mesh.triangles.push_back(corners);
    for (std::size_t k = 0; k < 3; ++k) ++count[{corners[k], corners[(k + 1) % 3]}];
  }
  mesh.regions.assign(mesh.triangles.size(), 0);
  for (const auto& [side, once] : count) {
    if (count.contains({side.second, side.first})) continue;
    mesh.edges.push_back({side.first, side.second});
    mesh.labels.push_back(Bottom);
  }
  return mesh;
}

/// Two meshes as one, not connected; the labels of the second are shifted.
inline Mesh joined(const Mesh& a, const Mesh& b, int label_shift) {
  Mesh mesh = a;
  const int n = a.num_vertices();
  mesh.points.insert(mesh.points.end(), b.points.begin(), b.points.end());
  for (const auto& t : b.triangles) mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  mesh.regions.insert(mesh.regions.end(), b.regions.begin(), b.regions.end());
  for (const auto& e : b.edges) mesh.edges.push_back({e[0] + n, e[1] + n});
  for (const int label : b.labels) mesh.labels.push_back(label + label_shift);
  return mesh;
}

}  // namespace parmesan::support
