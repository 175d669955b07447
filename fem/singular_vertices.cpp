#include "fem/singular_vertices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fem/coefficients.h"
#include "fem/contradicting_data.h"
#include "fem/p1.h"
#include "fem/side_integrals.h"
#include "fem/stabilization.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// What meets at a vertex.
struct Corner {
  double least_angle = HUGE_VAL, greatest_angle = 0.0;  // of the parts that meet
  bool has_given = false;                               // a side of the boundary with given values
  bool has_other = false;                               // one with another condition
  double least = HUGE_VAL, greatest = -HUGE_VAL;        // of the values that its sides give it
  int lines = 0;                                        // sides across which the gradient jumps

  bool on_boundary() const { return has_given || has_other; }

  /// scale: of the values given on the boundary.
  bool is_singular(double scale) const {
    constexpr double jump = 1e-6;
    constexpr double straight = std::numbers::pi;
    constexpr double reentrant = 1.15 * straight;
    constexpr double right = 0.55 * straight;
    constexpr double turn = straight / 6.0;
    if (greatest - least > jump * scale) return true;
    if (on_boundary())
      return greatest_angle > reentrant || (has_given && has_other && greatest_angle > right) || lines > 0;
    if (lines != 2) return lines > 0;
    return greatest_angle > straight + turn || least_angle < straight - turn;
  }
};

/// K in a triangle beside a corner; in the corner itself it may have no value.
Diffusion diffusion_beside(const Mesh& mesh, const Problem& problem, std::size_t triangle, const Point& corner) {
  constexpr double share = 0.01;  // of the way to the centre
  const auto [a, b, c] = mesh.triangles[triangle];
  const Point center = (1.0 / 3.0) * (mesh.points[at(a)] + mesh.points[at(b)] + mesh.points[at(c)]);
  return diffusion_at(problem, lerp(corner, center, share), mesh.regions[triangle]);
}

/// The angle from a to b in the metric K^-1, whose K det K^-1 = a^T adj(K) b.
double angle_in_metric(const Diffusion& k, const Vector& a, const Vector& b) {
  const Diffusion adjugate{k.yy, -k.xy, k.xx};
  return std::atan2(std::sqrt(determinant(k)) * cross(a, b), dot(a, adjugate * b));
}

/// At the vertices on the boundary and on lines.
void add_angles(const SmoothParts& parts, const Problem& problem, std::vector<Corner>& corners) {
  const Mesh& mesh = parts.mesh();
  std::vector<double> angles(mesh.points.size(), 0.0);
  const auto corner_of = [&](std::size_t v) -> Corner& { return corners[at(parts.source(v))]; };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = at(mesh.triangles[t][k]);
      if (!corner_of(v).on_boundary() && corner_of(v).lines == 0) continue;
      const Point& p = mesh.points[v];
      const Vector a = mesh.points[at(mesh.triangles[t][(k + 1) % 3])] - p;
      const Vector b = mesh.points[at(mesh.triangles[t][(k + 2) % 3])] - p;
      angles[v] += angle_in_metric(diffusion_beside(mesh, problem, t, p), a, b);
    }
  }
  for (std::size_t v = 0; v < angles.size(); ++v) {
    Corner& corner = corner_of(v);
    corner.least_angle = std::min(corner.least_angle, angles[v]);
    corner.greatest_angle = std::max(corner.greatest_angle, angles[v]);
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
    ++corners[at(side.from)].lines;
    ++corners[at(side.to)].lines;
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

std::vector<int> singular_vertices(const SmoothParts& parts, const Problem& problem, const std::vector<Side>& sides) {
  const Mesh& mesh = parts.whole();
  std::vector<Corner> corners(mesh.points.size());
  const double scale = add_given_values(mesh, problem, sides, corners);
  add_lines(mesh, problem, sides, corners);
  add_angles(parts, problem, corners);
  std::vector<char> is_singular = contradicting_data(mesh, problem, sides);
  for (std::size_t v = 0; v < corners.size(); ++v)
    if (corners[v].is_singular(scale)) is_singular[v] = 1;
  if (problem.velocity) leave_advected(mesh, problem, is_singular);
  std::vector<int> singular;
  for (std::size_t v = 0; v < corners.size(); ++v)
    if (is_singular[v]) singular.push_back(static_cast<int>(v));
  return singular;
}

}  // namespace parmesan
