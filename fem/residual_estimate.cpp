#include "fem/residual_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "fem/adjacency.h"
#include "fem/boundary_conditions.h"
#include "fem/coefficients.h"
#include "fem/p1.h"
#include "fem/point_sources.h"
#include "fem/recovery.h"
#include "fem/side_integrals.h"
#include "fem/sides.h"
#include "fem/smooth_parts.h"
#include "mesher/index.h"
#include "mesher/parallel.h"

namespace parmesan {
namespace {

/// A triangle and the solution on it.
struct Piece {
  P1Element element;
  std::array<double, 3> u{};
  Vector gradient;
  int region = 0;
};

Piece piece(const Mesh& mesh, std::span<const double> values, std::size_t t) {
  Piece p{p1_element(mesh, static_cast<int>(t)), at_corners(mesh, t, values), {}, mesh.regions[t]};
  p.gradient = p1_gradient(p.element, p.u);
  return p;
}

/// The square of the L2 norm of f - b.grad u_h - c u_h.
double squared_residual(const Problem& problem, const Piece& p) {
  double sum = 0.0;
  for (const TrianglePoint& q : degree4_rule()) {
    const Point x = p.element.at(q.lambda);
    const double u = p1_value(q.lambda, p.u);
    const double r = source_at(problem, x, p.region) - dot(velocity_at(problem, x, p.region), p.gradient) -
                     reaction_at(problem, x, p.region) * u;
    sum += q.weight * r * r;
  }
  return p.element.area * sum;
}

/// Half the jump of n.K grad u_h across each side of each triangle, and what the boundary conditions put in its place;
/// side i starts at corner i.
using SideResiduals = std::vector<std::array<double, 3>>;

/// The triangle on the other side of the edge a-b of triangle t, -1 on the boundary.
int opposite(const Mesh& mesh, const Adjacency& around, int t, int a, int b) {
  for (const int other : around.of(a)) {
    if (other == t) continue;
    for (const int v : mesh.triangles[at(other)]) {
      if (v == b) return other;
    }
  }
  return -1;
}

Vector unit_normal(const Point& from, const Point& to) {
  const Vector d = to - from;
  return (1.0 / norm(d)) * Vector{d.y, -d.x};
}

double flux(const Problem& problem, const Piece& p, const Point& x, const Vector& n) {
  return dot(n, diffusion_at(problem, x, p.region) * p.gradient);
}

SideResiduals half_jumps(const Mesh& mesh, const Problem& problem, const Adjacency& around,
                         const std::vector<Piece>& pieces) {
  SideResiduals residuals(pieces.size(), {0.0, 0.0, 0.0});
  for_each_in_parallel(pieces.size(), [&](std::size_t t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      const int other = opposite(mesh, around, static_cast<int>(t), a, b);
      if (other < 0) continue;
      const Point middle = midpoint(mesh.points[at(a)], mesh.points[at(b)]);
      const Vector n = unit_normal(mesh.points[at(a)], mesh.points[at(b)]);
      residuals[t][i] = 0.5 * (flux(problem, pieces[t], middle, n) - flux(problem, pieces[at(other)], middle, n));
    }
  });
  return residuals;
}

/// g - a u - n.K grad u_h, in the mean over the side; zero with Dirichlet data.
double data_residual(const Mesh& mesh, const Problem& problem, const Side& side, const BoundaryCondition& condition,
                     const Piece& p, std::span<const double> values) {
  if (condition.kind == BoundaryKind::Dirichlet) return 0.0;
  const SideMoments g = side_moments(mesh, side, condition.value);
  double given = g.from + g.to;
  if (condition.kind == BoundaryKind::Robin) {
    const RobinMoments a = robin_moments(mesh, side, condition.coefficient);
    given -= (a.from_from + a.from_to) * values[at(side.from)] + (a.from_to + a.to_to) * values[at(side.to)];
  }
  const Point middle = midpoint(mesh.points[at(side.from)], mesh.points[at(side.to)]);
  return given / side.length - flux(problem, p, middle, side.normal);
}

/// The residual on the side of triangle t that starts at this vertex.
double& residual_of(const Mesh& mesh, SideResiduals& residuals, int t, int from) {
  const auto& corners = mesh.triangles[at(t)];
  const auto corner = std::ranges::find(corners, from) - corners.begin();
  return residuals[at(t)][static_cast<std::size_t>(corner)];
}

SideResiduals side_residuals(const Mesh& mesh, const Problem& problem, const std::vector<Piece>& pieces,
                             std::span<const double> values) {
  const Adjacency around = vertex_triangles(mesh);
  SideResiduals residuals = half_jumps(mesh, problem, around, pieces);
  for (const Side& side : labelled_sides(mesh)) {
    const BoundaryCondition* condition = condition_on(problem, side);
    if (!condition) continue;
    const Piece& inside = pieces[at(side.triangle)];
    residual_of(mesh, residuals, side.triangle, side.from) =
        data_residual(mesh, problem, side, *condition, inside, values);
    if (side.interior)  // a Dirichlet condition, for both sides
      residual_of(mesh, residuals, opposite(mesh, around, side.triangle, side.from, side.to), side.to) = 0.0;
  }
  return residuals;
}

/// int_T e e^T, e linear with these corner values, by the edge midpoints.
SymmetricTensor squared_differences(const Piece& p, const std::array<Vector, 3>& e) {
  SymmetricTensor g;
  for (std::size_t i = 0; i < 3; ++i) g = g + outer_square(midpoint(e[i], e[(i + 1) % 3]));
  return (p.element.area / 3.0) * g;
}

/// 2 sum (p_i - centroid)(p_i - centroid)^T.
SymmetricTensor squared_lengths(const P1Element& element) {
  constexpr double third = 1.0 / 3.0;
  const Point centroid = element.at({third, third, third});
  SymmetricTensor s;
  for (const Point& corner : element.p) s = s + outer_square(corner - centroid);
  return 2.0 * s;
}

/// rho of the docstring; 4 |T| / sqrt3 = l1 l2.
double residual_norm(const Problem& problem, const Piece& p, const std::array<double, 3>& half_jumps) {
  constexpr double of_inside = 0.04, of_sides = 0.18;
  const double root = std::sqrt(4.0 * std::numbers::inv_sqrt3 * p.element.area);
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += norm(p.element.p[(i + 1) % 3] - p.element.p[i]) * std::abs(half_jumps[i]) / root;
  return of_inside * std::sqrt(squared_residual(problem, p)) + of_sides * sum;
}

double squared_error(const Problem& problem, const Piece& p, const std::array<Vector, 3>& e,
                     const std::array<double, 3>& sides) {
  constexpr double third = 1.0 / 3.0;
  const SymmetricTensor g = squared_differences(p, e);
  if (trace(g) == 0.0) return 0.0;
  const Diffusion k = diffusion_at(problem, p.element.at({third, third, third}), p.region);
  const double along = contraction(g, k) / trace(g);
  return residual_norm(problem, p, sides) * std::sqrt(contraction(g, squared_lengths(p.element))) / along;
}

std::vector<char> holds_point_source(const Mesh& mesh, const Problem& problem) {
  std::vector<char> holds(mesh.triangles.size(), 0);
  for (const std::vector<TrianglePlace>& places : places_of_sources(mesh, problem))
    for (const TrianglePlace& place : places) holds[at(place.triangle)] = 1;
  return holds;
}

}  // namespace

double residual_estimate(const Mesh& mesh, const Problem& problem, std::span<const double> values) {
  const SmoothParts parts(mesh, problem, labelled_sides(mesh));
  const std::vector<Vector> gradients = recover_gradients(parts.mesh(), parts.spread(values));
  std::vector<Piece> pieces(mesh.triangles.size());
  for_each_in_parallel(pieces.size(), [&](std::size_t t) { pieces[t] = piece(mesh, values, t); });
  const SideResiduals sides = side_residuals(mesh, problem, pieces, values);
  std::vector<double> squares(pieces.size(), 0.0);
  const std::vector<char> leave_out = holds_point_source(mesh, problem);
  for_each_in_parallel(pieces.size(), [&](std::size_t t) {
    if (leave_out[t]) return;
    std::array<Vector, 3> e{};
    for (std::size_t i = 0; i < 3; ++i) e[i] = gradients[at(parts.mesh().triangles[t][i])] - pieces[t].gradient;
    squares[t] = squared_error(problem, pieces[t], e, sides[t]);
  });
  return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0));
}

}  // namespace parmesan
