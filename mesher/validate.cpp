#include "mesher/validate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesher/errors.h"
#include "mesher/geometry/predicates.h"
#include "mesher/geometry/rounding.h"
#include "mesher/geometry/segment_contacts.h"
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

/// How often the triangles at a point pass the direction of x from there: twice is once too often, since then they
/// overlap.
enum Rounds : std::uint8_t { NoTriangle, None, Once, MoreOften };

/// Returns the rounds at each point. Of a counter-clockwise triangle the corner between the others in height passes the
/// direction of x where it is to the right of these.
std::vector<std::uint8_t> check_triangles(const Mesh& mesh) {
  std::vector<std::uint8_t> rounds(mesh.points.size(), NoTriangle);
  for (int i = 0; i < mesh.num_triangles(); ++i) {
    std::array<Point, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = mesh.points[at(mesh.triangles[at(i)][k])];
    const double area = orient2d(corner[0], corner[1], corner[2]);
    if (!(area > 0.0))
      throw GeometryError(
          "triangle " + number_text(mesh, i) + (area < 0.0 ? " is clockwise, not counter-clockwise" : " has no area"),
          {i});
    std::array<unsigned, 3> goes_down{};  // from corner k to the next; at one height to the left is down
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &from = corner[k], &to = corner[(k + 1) % 3];
      goes_down[k] = static_cast<unsigned>(to.y < from.y) |
                     (static_cast<unsigned>(to.y == from.y) & static_cast<unsigned>(to.x < from.x));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint8_t& count = rounds[at(mesh.triangles[at(i)][k])];
      const unsigned passes = goes_down[k] & goes_down[(k + 2) % 3];
      count = static_cast<std::uint8_t>(std::min<unsigned>(MoreOften, std::max<unsigned>(count, None) + passes));
    }
  }
  for (int i = 0; i < mesh.num_vertices(); ++i) {
    if (rounds[at(i)] != NoTriangle) continue;
    throw GeometryError("point " + number_text(mesh, i) + " belongs to no triangle", {i});
  }
  return rounds;
}

std::string name_of(const Mesh& mesh, int a, int b) { return number_text(mesh, a) + "-" + number_text(mesh, b); }

bool is_sound(const MeshSide& side) {
  if (side.left < 0 && side.right < 0) return false;
  return !side.is_boundary() || (side.edge >= 0 && side.edge_goes_down != (side.right < 0));
}

/// What is looked for side by side.
struct SidesFound {
  std::optional<MeshSide> lowest_unsound;  // that of the lowest end points
  std::vector<Segment> boundary;
};

// What for_each_side itself finds wrong comes first.
SidesFound look_at_sides(const Mesh& mesh, const HalfEdges& half_edges) {
  std::mutex mutex;
  SidesFound found;
  std::vector<char> is_boundary(mesh.edges.size(), 0);
  const auto ends = [](const MeshSide& side) { return std::pair(side.low, side.high); };
  for_each_side(mesh, half_edges, [&](const MeshSide& side) {
    if (side.is_boundary() && side.edge >= 0) is_boundary[at(side.edge)] = 1;
    if (is_sound(side)) return;
    const std::lock_guard lock(mutex);
    if (!found.lowest_unsound || ends(side) < ends(*found.lowest_unsound)) found.lowest_unsound = side;
  });
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (is_boundary[e] != 0) found.boundary.push_back({mesh.edges[e][0], mesh.edges[e][1], 0});
  return found;
}

/// Whether each of two segments that cross ends farther from the other, to both sides, than rounding moves a point.
bool cross_by_more_than_rounding(const Mesh& mesh, const Segment& s, const Segment& t, double rounding) {
  const auto point = [&mesh](int v) { return mesh.points[at(v)]; };
  const auto is_far = [&](int v, const Segment& from) {
    const double doubled = doubled_area(point(from.a), point(from.b), point(v));
    return std::abs(doubled) > rounding * norm(point(from.b) - point(from.a));
  };
  return is_far(s.a, t) && is_far(s.b, t) && is_far(t.a, s) && is_far(t.b, s);
}

/// Parts that lie across each other share no point, but their boundaries cross.
void refuse_crossings(const Mesh& mesh, const SidesFound& sides) {
  constexpr std::size_t max_crossings = 1000;
  const double rounding = rounding_of(mesh.points);
  for (const auto& [i, j] : evident_crossings(mesh.points, sides.boundary, max_crossings).pairs) {
    const Segment& s = sides.boundary[at(i)];
    const Segment& t = sides.boundary[at(j)];
    if (!cross_by_more_than_rounding(mesh, s, t, rounding)) continue;
    const auto point = [&mesh](int v) { return mesh.points[at(v)]; };
    throw GeometryError("the boundary sides " + name_of(mesh, s.a, s.b) + " and " + name_of(mesh, t.a, t.b) +
                            " cross at " + text(crossing_point(point(s.a), point(s.b), point(t.a), point(t.b))) +
                            ": the triangles overlap",
                        {s.a, s.b, t.a, t.b});
  }
}

// Without what needs to know which triangles share a side. Returns the rounds of check_triangles.
std::vector<std::uint8_t> check_parts(const Mesh& mesh) {
  check_counts(mesh);
  check_regions(mesh);
  check_points(mesh);
  check_indices(mesh, mesh.triangles, "triangle");
  check_indices(mesh, mesh.edges, "edge");
  check_required(mesh, mesh.required.vertices, mesh.points.size(), "point");
  check_required(mesh, mesh.required.edges, mesh.edges.size(), "edge");
  check_required(mesh, mesh.required.triangles, mesh.triangles.size(), "triangle");
  return check_triangles(mesh);
}

[[noreturn]] void refuse(const Mesh& mesh, const MeshSide& side) {
  const auto name = [&] { return name_of(mesh, side.low, side.high); };
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

void check_boundary(const Mesh& mesh, const std::vector<std::uint8_t>& rounds, const HalfEdges& half_edges) {
  const SidesFound sides = look_at_sides(mesh, half_edges);
  if (sides.lowest_unsound) refuse(mesh, *sides.lowest_unsound);
  const auto found = std::ranges::find_if(rounds, [](std::uint8_t count) { return count == MoreOften; });
  if (found != rounds.end()) {
    const auto v = static_cast<int>(found - rounds.begin());
    throw GeometryError("the triangles at point " + number_text(mesh, v) + " overlap: they go round it more than once",
                        {v});
  }
  refuse_crossings(mesh, sides);
}

}  // namespace

// Half-edges are made once indices are known to be in range.
void validate(const Mesh& mesh) {
  const std::vector<std::uint8_t> rounds = check_parts(mesh);
  check_boundary(mesh, rounds, HalfEdges(mesh));
}

void validate(const Mesh& mesh, const HalfEdges& half_edges) {
  const std::vector<std::uint8_t> rounds = check_parts(mesh);
  check_boundary(mesh, rounds, half_edges);
}

}  // namespace parmesan
