#include "fem/singular_vertices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fem/coefficients.h"
#include "fem/p1.h"
#include "fem/smooth_parts.h"
#include "fem/stabilization.h"

namespace parmesan {

namespace {

/// What meets at a vertex.
struct Corner {
  double angle = 0.0;      // of all triangles
  bool has_given = false;  // a side of the boundary with given values
  bool has_other = false;  // one with another condition
  int lines = 0;           // sides across which the gradient jumps
  Vector directions;       // the sum of theirs, away from the vertex

  bool is_singular() const {
    constexpr double reentrant = 1.15 * std::numbers::pi;
    constexpr double right = 0.55 * std::numbers::pi;
    constexpr double straight = 0.5;  // |sum| of two directions that differ by 30 degrees from opposite ones
    const bool on_boundary = has_given || has_other;
    if (on_boundary) return angle > reentrant || (has_given && has_other && angle > right) || lines > 0;
    return lines == 1 || lines > 2 || (lines == 2 && norm(directions) > straight);
  }
};

void add_angles(const Mesh& mesh, std::vector<Corner>& corners) {
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(triangle[k]);
      const Vector a = mesh.points[static_cast<std::size_t>(triangle[(k + 1) % 3])] - mesh.points[v];
      const Vector b = mesh.points[static_cast<std::size_t>(triangle[(k + 2) % 3])] - mesh.points[v];
      corners[v].angle += std::atan2(a.x * b.y - a.y * b.x, dot(a, b));
    }
  }
}

/// Leaves those out where diffusion is not yet resolved.
void leave_advected(const Mesh& mesh, const Problem& problem, std::vector<char>& is_singular) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    if (std::ranges::none_of(corners, [&](int v) { return is_singular[static_cast<std::size_t>(v)] != 0; })) continue;
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    const MeanCoefficients mean = mean_coefficients(problem, element, mesh.regions[t]);
    if (mesh_peclet(element, mean.velocity, mean.diffusion) <= 1.0) continue;
    for (const int v : corners) is_singular[static_cast<std::size_t>(v)] = 0;
  }
}

}  // namespace

std::vector<int> singular_vertices(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides) {
  std::vector<Corner> corners(mesh.points.size());
  add_angles(mesh, corners);
  for (const Side& side : sides) {
    Corner& from = corners[static_cast<std::size_t>(side.from)];
    Corner& to = corners[static_cast<std::size_t>(side.to)];
    if (!side.interior) {
      const bool given = problem.boundary.at(side.label).kind == BoundaryKind::Dirichlet;
      for (Corner* corner : {&from, &to}) (given ? corner->has_given : corner->has_other) = true;
    } else if (gradient_jumps(mesh, problem, side)) {
      const Vector along{-side.normal.y, side.normal.x};
      from.directions = from.directions + along;
      to.directions = to.directions - along;
      ++from.lines;
      ++to.lines;
    }
  }
  std::vector<char> is_singular(corners.size());
  for (std::size_t v = 0; v < corners.size(); ++v) is_singular[v] = corners[v].is_singular() ? 1 : 0;
  if (problem.velocity) leave_advected(mesh, problem, is_singular);
  std::vector<int> singular;
  for (std::size_t v = 0; v < corners.size(); ++v)
    if (is_singular[v]) singular.push_back(static_cast<int>(v));
  return singular;
}

}  // namespace parmesan
