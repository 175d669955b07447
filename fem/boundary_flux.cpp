#include "fem/boundary_flux.h"

#include <limits>

#include "fem/boundary_conditions.h"
#include "fem/coefficients.h"
#include "fem/p1.h"
#include "fem/side_integrals.h"

namespace parmesan {

namespace {

/// n.K grad u_h in the triangle at the middle of the side, of interior constraints from both sides.
double element_flux(const Mesh& mesh, const Problem& problem, const Side& side, std::span<const double> values) {
  const Point middle = midpoint(mesh.points[static_cast<std::size_t>(side.from)],  //
                                mesh.points[static_cast<std::size_t>(side.to)]);
  const auto out_of = [&](int triangle, int region) {
    const std::array<double, 3> u = at_corners(mesh, static_cast<std::size_t>(triangle), values);
    return dot(side.normal, diffusion_at(problem, middle, region) * p1_gradient(p1_element(mesh, triangle), u));
  };
  const double flux = out_of(side.triangle, side.region);
  return side.interior ? flux - out_of(side.other_triangle, side.other_region) : flux;
}

/// What the source's own flux adds to the residuals of a Dirichlet side, NaN where it is not finite: data may be
/// singular on the boundary.
SideMoments own_flux(const Mesh& mesh, const Problem& problem, const Side& side) {
  try {
    return source_flux_moments(mesh, problem, side);
  } catch (const ProblemError&) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, unknown, unknown};
  }
}

/// What the Dirichlet sides at a vertex have to share.
struct VertexFlux {
  double remainder = 0.0;  // residual minus the fluxes of the elements
  double length = 0.0;     // of the sides
};

double given_flux(const Mesh& mesh, const Side& side, const BoundaryCondition& condition,
                  std::span<const double> values, std::span<const Surplus> surplus) {
  const SideMoments g = side_moments(mesh, side, condition.value);
  if (condition.kind == BoundaryKind::Neumann) return g.from + g.to;
  const RobinMoments a = robin_moments(mesh, side, condition.coefficient);
  const double from = values[static_cast<std::size_t>(side.from)];
  const double to = values[static_cast<std::size_t>(side.to)];
  const double flux = g.from + g.to - (a.from_from + a.from_to) * from - (a.from_to + a.to_to) * to;
  if (surplus.empty()) return flux;
  const double s = surplus[static_cast<std::size_t>(side.triangle)][apex_of(mesh, side, side.triangle)];
  const SideMoments q = quadratic_robin_moments(mesh, side, condition.coefficient, s);
  return flux - q.from - q.to;
}

}  // namespace

std::map<int, double> boundary_fluxes(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                                      std::span<const double> residual, std::span<const double> values,
                                      std::span<const Surplus> surplus) {
  std::map<int, double> fluxes;
  std::map<int, VertexFlux> at;
  std::vector<const Side*> dirichlet;
  for (const Side& side : sides) {
    const BoundaryCondition* condition = condition_on(problem, side);
    if (!condition) continue;
    double& flux = fluxes[side.label];
    if (condition->kind != BoundaryKind::Dirichlet) {
      flux += given_flux(mesh, side, *condition, values, surplus);
      continue;
    }
    dirichlet.push_back(&side);
    const double in_element = side.length * element_flux(mesh, problem, side, values);
    flux += in_element;
    const SideMoments own = own_flux(mesh, problem, side);
    const auto add = [&](int v, double moment) {
      VertexFlux& vertex = at.try_emplace(v, VertexFlux{residual[static_cast<std::size_t>(v)], 0.0}).first->second;
      vertex.remainder += moment - 0.5 * in_element;
      vertex.length += side.length;
    };
    add(side.from, own.from);
    add(side.to, own.to);
  }
  for (const Side* side : dirichlet) {
    for (const int v : {side->from, side->to}) {
      fluxes[side->label] += at.at(v).remainder * side->length / at.at(v).length;
    }
  }
  return fluxes;
}

}  // namespace parmesan
