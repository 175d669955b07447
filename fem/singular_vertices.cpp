#include "fem/singular_vertices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fem/coefficients.h"
#include "fem/p1.h"
#include "fem/side_integrals.h"
#include "fem/smooth_parts.h"
#include "fem/stabilization.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// What meets at a vertex.
struct Corner {
  double angle = 0.0;                             // of all triangles
  bool has_given = false;                         // a side of the boundary with given values
  bool has_other = false;                         // one with another condition
  double least = HUGE_VAL, greatest = -HUGE_VAL;  // of the values that its sides give it
  int lines = 0;                                  // sides across which the gradient jumps
  Vector directions;                              // the sum of theirs, away from the vertex

  /// scale: of the values given on the boundary.
  bool is_singular(double scale) const {
    constexpr double jump = 1e-6;
    constexpr double reentrant = 1.15 * std::numbers::pi;
    constexpr double right = 0.55 * std::numbers::pi;
    constexpr double straight = 0.5;  // |sum| of two directions that differ by 30 degrees from opposite ones
    const bool on_boundary = has_given || has_other;
    if (greatest - least > jump * scale) return true;
    if (on_boundary) return angle > reentrant || (has_given && has_other && angle > right) || lines > 0;
    return lines == 1 || lines > 2 || (lines == 2 && norm(directions) > straight);
  }
};

void add_angles(const Mesh& mesh, std::vector<Corner>& corners) {
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(triangle[k]);
      const Vector a = mesh.points[at(triangle[(k + 1) % 3])] - mesh.points[v];
      const Vector b = mesh.points[at(triangle[(k + 2) % 3])] - mesh.points[v];
      corners[v].angle += std::atan2(a.x * b.y - a.y * b.x, dot(a, b));
    }
  }
}

/// Returns the largest of the values.
double add_given_values(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                        std::vector<Corner>& corners) {
  double largest = 0.0;
  for (const Side& side : sides) {
    if (side.interior) continue;
    const BoundaryCondition& condition = problem.boundary.at(side.label);
    const bool given = condition.kind == BoundaryKind::Dirichlet;
    for (const int vertex : {side.from, side.to}) {
      const auto v = static_cast<std::size_t>(vertex);
      (given ? corners[v].has_given : corners[v].has_other) = true;
      if (!given) continue;
      const double value = data_at(condition.value, side, mesh.points[v]);
      corners[v].least = std::min(corners[v].least, value);
      corners[v].greatest = std::max(corners[v].greatest, value);
      largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

void add_lines(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides, std::vector<Corner>& corners) {
  for (const Side& side : sides) {
    if (!side.interior || !gradient_jumps(mesh, problem, side)) continue;
    Corner& from = corners[at(side.from)];
    Corner& to = corners[at(side.to)];
    const Vector along{-side.normal.y, side.normal.x};
    from.directions = from.directions + along;
    to.directions = to.directions - along;
    ++from.lines;
    ++to.lines;
  }
}

/// Leaves those out where diffusion is not yet resolved.
void leave_advected(const Mesh& mesh, const Problem& problem, std::vector<char>& is_singular) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    if (std::ranges::none_of(corners, [&](int v) { return is_singular[at(v)] != 0; })) continue;
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    const MeanCoefficients mean = mean_coefficients(problem, element, mesh.regions[t]);
    if (mesh_peclet(element, mean.velocity, mean.diffusion) <= 1.0) continue;
    for (const int v : corners) is_singular[at(v)] = 0;
  }
}

}  // namespace

std::vector<int> singular_vertices(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides) {
  std::vector<Corner> corners(mesh.points.size());
  add_angles(mesh, corners);
  const double scale = add_given_values(mesh, problem, sides, corners);
  add_lines(mesh, problem, sides, corners);
  std::vector<char> is_singular(corners.size());
  for (std::size_t v = 0; v < corners.size(); ++v) is_singular[v] = corners[v].is_singular(scale) ? 1 : 0;
  if (problem.velocity) leave_advected(mesh, problem, is_singular);
  std::vector<int> singular;
  for (std::size_t v = 0; v < corners.size(); ++v)
    if (is_singular[v]) singular.push_back(static_cast<int>(v));
  return singular;
}

}  // namespace parmesan
