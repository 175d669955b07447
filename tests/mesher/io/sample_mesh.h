#pragma once

#include <cmath>

#include "mesher/mesh.h"

namespace parmesan::support {

/// The unit square in n x n cells of two triangles, sides labelled bottom 1, right 2, top 3, left 4,
/// regions 7 below and 8 above the middle; coordinates, apart from the corners, with many digits.
inline Mesh sample_mesh(int n) {
  Mesh mesh;
  const auto place = [n](int i) { return i == 0 ? 0.0 : std::sin(std::acos(-1.0) / 2.0 * i / n); };
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) mesh.points.push_back({place(i), place(j)});
  }
  const auto vertex = [n](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      mesh.regions.insert(mesh.regions.end(), 2, 2 * j < n ? 7 : 8);
    }
  }
  for (int i = 0; i < n; ++i) {
    mesh.edges.push_back({vertex(i, 0), vertex(i + 1, 0)});
    mesh.edges.push_back({vertex(n, i), vertex(n, i + 1)});
    mesh.edges.push_back({vertex(n - i, n), vertex(n - i - 1, n)});
    mesh.edges.push_back({vertex(0, n - i), vertex(0, n - i - 1)});
    mesh.labels.insert(mesh.labels.end(), {1, 2, 3, 4});
  }
  return mesh;
}

/// Equal in everything that files can carry.
inline bool same_arrays(const Mesh& a, const Mesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.regions == b.regions && a.edges == b.edges &&
         a.labels == b.labels;
}

}  // namespace parmesan::support
