#include "mesher/validate.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "mesher/errors.h"
#include "mesher/geometry/predicates.h"
#include "mesher/index.h"
#include "mesher/mesh_sides.h"
#include "mesher/number_text.h"

namespace parmesan {

namespace {

std::string count_mismatch(const char* one, std::size_t num_one, const char* other, std::size_t num_other) {
  return "the mesh has " + std::to_string(num_one) + " " + one + " but " + std::to_string(num_other) + " " + other +
         "; there must be one each";
}

void check_counts(const Mesh& mesh) {
  if (mesh.triangles.empty()) throw GeometryError("the mesh has no triangles");
  if (mesh.regions.size() != mesh.triangles.size()) {
    throw GeometryError(count_mismatch("triangles", mesh.triangles.size(), "regions", mesh.regions.size()));
  }
  if (mesh.labels.size() != mesh.edges.size()) {
    throw GeometryError(count_mismatch("edges", mesh.edges.size(), "labels", mesh.labels.size()));
  }
}

void check_regions(const Mesh& mesh) {
  const auto found = std::ranges::find_if(mesh.regions, [](int region) { return region < min_region; });
  if (found == mesh.regions.end()) return;
  const auto triangle = static_cast<int>(found - mesh.regions.begin());
  throw GeometryError("triangle " + number_text(mesh, triangle) + " has region " + std::to_string(*found) +
                          "; regions are numbered from " + std::to_string(min_region),
                      {triangle});
}

void check_points(const Mesh& mesh) {
  for (int i = 0; i < mesh.num_vertices(); ++i) {
    const Point& p = mesh.points[at(i)];
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      throw GeometryError("point " + number_text(mesh, i) + " has a coordinate that is not finite", {i});
    }
    if (std::max(std::abs(p.x), std::abs(p.y)) > max_coordinate)
      throw InputError("point " + number_text(mesh, i) + " has a coordinate beyond " + text(max_coordinate) +
                       ": scale the mesh");
  }
}

/// kind: "triangle" or "edge".
template <std::size_t N>
void check_indices(const Mesh& mesh, const std::vector<std::array<int, N>>& cells, const char* kind) {
  for (int i = 0; i < static_cast<int>(cells.size()); ++i) {
    for (const int v : cells[at(i)]) {
      if (v >= 0 && v < mesh.num_vertices()) continue;
      throw GeometryError(std::string(kind) + " " + number_text(mesh, i) + " refers to point " + number_text(mesh, v) +
                              "; points are " + number_text(mesh, 0) + " to " +
                              number_text(mesh, mesh.num_vertices() - 1),
                          {i});
    }
  }
}

void check_required(const Mesh& mesh, const std::vector<int>& numbers, std::size_t count, const char* kind) {
  for (const int number : numbers) {
    if (number >= 0 && number < static_cast<int>(count)) continue;
    throw GeometryError(std::string(kind) + " " + number_text(mesh, number) + " is required, but there are only " +
                            std::to_string(count),
                        {number});
  }
}

void check_triangles(const Mesh& mesh) {
  std::vector<bool> is_used(mesh.points.size(), false);
  for (int i = 0; i < mesh.num_triangles(); ++i) {
    std::array<Point, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = static_cast<std::size_t>(mesh.triangles[at(i)][k]);
      is_used[v] = true;
      corner[k] = mesh.points[v];
    }
    const double area = orient2d(corner[0], corner[1], corner[2]);
    if (area > 0.0) continue;
    throw GeometryError(
        "triangle " + number_text(mesh, i) + (area < 0.0 ? " is clockwise, not counter-clockwise" : " has no area"),
        {i});
  }
  for (int i = 0; i < mesh.num_vertices(); ++i) {
    if (is_used[at(i)]) continue;
    throw GeometryError("point " + number_text(mesh, i) + " belongs to no triangle", {i});
  }
}

bool is_sound(const MeshSide& side) {
  if (side.left < 0 && side.right < 0) return false;
  return !side.is_boundary() || (side.edge >= 0 && side.edge_goes_down != (side.right < 0));
}

// That of the lowest end points. What for_each_side itself finds wrong comes first.
std::optional<MeshSide> lowest_unsound_side(const Mesh& mesh, const HalfEdges& half_edges) {
  std::mutex mutex;
  std::optional<MeshSide> lowest;
  const auto ends = [](const MeshSide& side) { return std::pair(side.low, side.high); };
  for_each_side(mesh, half_edges, [&](const MeshSide& side) {
    if (is_sound(side)) return;
    const std::lock_guard lock(mutex);
    if (!lowest || ends(side) < ends(*lowest)) lowest = side;
  });
  return lowest;
}

// Without what needs to know which triangles share a side.
void check_parts(const Mesh& mesh) {
  check_counts(mesh);
  check_regions(mesh);
  check_points(mesh);
  check_indices(mesh, mesh.triangles, "triangle");
  check_indices(mesh, mesh.edges, "edge");
  check_required(mesh, mesh.required.vertices, mesh.points.size(), "point");
  check_required(mesh, mesh.required.edges, mesh.edges.size(), "edge");
  check_required(mesh, mesh.required.triangles, mesh.triangles.size(), "triangle");
  check_triangles(mesh);
}

[[noreturn]] void refuse(const Mesh& mesh, const MeshSide& side) {
  const auto name = [&] { return number_text(mesh, side.low) + "-" + number_text(mesh, side.high); };
  if (side.left < 0 && side.right < 0) {
    throw GeometryError("edge " + number_text(mesh, side.edge) + " (" + name() + ") is not a side of any triangle",
                        {side.edge});
  }
  if (side.edge < 0) {
    const int triangle = side.left < 0 ? side.right : side.left;
    throw GeometryError("triangle " + number_text(mesh, triangle) + " has the boundary side " + name() +
                            ", which no labelled edge covers",
                        {triangle});
  }
  throw GeometryError("boundary edge " + number_text(mesh, side.edge) + " (" + name() +
                          ") has the domain to its right; boundary edges have it to their left",
                      {side.edge});
}

}  // namespace

void validate(const Mesh& mesh) {
  check_parts(mesh);
  if (const std::optional<MeshSide> side = lowest_unsound_side(mesh, HalfEdges(mesh))) refuse(mesh, *side);
}

void validate(const Mesh& mesh, const HalfEdges& half_edges) {
  check_parts(mesh);
  if (const std::optional<MeshSide> side = lowest_unsound_side(mesh, half_edges)) refuse(mesh, *side);
}

}  // namespace parmesan
