#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan::support {

/// A mesh whatever the order and numbers of its parts: elements by their places, with the names of labels and regions.
struct CanonicalMesh {
  std::vector<std::tuple<std::array<double, 6>, std::string>> triangles;  // first the smallest corner
  std::vector<std::tuple<std::array<double, 4>, std::string>> edges;
  bool operator==(const CanonicalMesh&) const = default;
};

inline CanonicalMesh canonical(const Mesh& mesh) {
  CanonicalMesh result;
  const auto place = [&mesh](int v) {
    const Point& p = mesh.points[static_cast<std::size_t>(v)];
    return std::array{p.x, p.y};
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::array corners{place(mesh.triangles[i][0]), place(mesh.triangles[i][1]), place(mesh.triangles[i][2])};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.triangles.emplace_back(
        std::array{corners[0][0], corners[0][1], corners[1][0], corners[1][1], corners[2][0], corners[2][1]},
        label_name(mesh.region_names, mesh.regions[i]));
  }
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const auto a = place(mesh.edges[i][0]);
    const auto b = place(mesh.edges[i][1]);
    result.edges.emplace_back(std::array{a[0], a[1], b[0], b[1]}, label_name(mesh.label_names, mesh.labels[i]));
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  std::sort(result.edges.begin(), result.edges.end());
  return result;
}

}  // namespace parmesan::support
