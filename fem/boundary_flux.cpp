#include "fem/boundary_flux.h"

#include <limits>

#include "fem/boundary_conditions.h"
#include "fem/coefficients.h"
#include "fem/p1.h"
#include "fem/side_integrals.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// The gradient of u at points of a side, in a triangle beside it.
class GradientAlong {
 public:
  GradientAlong(const Mesh& mesh, const Side& side, int triangle, std::span<const double> values,
                std::span<const Surplus> surplus)
      : element_(p1_element(mesh, triangle)),
        linear_(p1_gradient(element_, at_corners(mesh, at(triangle), values))),
        quadratic_{surplus.empty() ? Surplus{} : surplus[at(triangle)]},
        apex_(apex_of(mesh, side, triangle)) {}

  Vector operator()(const Point& x) const {
    const std::size_t a = (apex_ + 1) % 3, b = (apex_ + 2) % 3;
    const Vector edge = element_.p[b] - element_.p[a];
    Barycentric lambda{};
    lambda[b] = dot(x - element_.p[a], edge) / squared_norm(edge);
    lambda[a] = 1.0 - lambda[b];
    return linear_ + quadratic_.gradient(element_, lambda);
  }

 private:
  P1Element element_;
  Vector linear_;
  Quadratic quadratic_;
  std::size_t apex_;
};

/// The moments of n.K grad u in the triangle, of interior constraints from both sides. K is that at each point: it may
/// grow many times over along a side.
SideMoments element_flux(const Mesh& mesh, const Problem& problem, const Side& side, std::span<const double> values,
                         std::span<const Surplus> surplus) {
  const auto out_of = [&](int triangle, int region) {
    const GradientAlong gradient(mesh, side, triangle, values, surplus);
    return side_moments(mesh, side, [&problem, &gradient, region](const Point& x, const Vector& normal, int) {
      return dot(normal, diffusion_at(problem, x, region) * gradient(x));
    });
  };
  const SideMoments flux = out_of(side.triangle, side.region);
  if (!side.interior) return flux;
  const SideMoments other = out_of(side.other_triangle, side.other_region);
  return {flux.from - other.from, flux.to - other.to, flux.magnitude + other.magnitude};
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
  std::map<int, VertexFlux> shared;
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
    const SideMoments in_element = element_flux(mesh, problem, side, values, surplus);
    flux += in_element.from + in_element.to;
    const SideMoments own = own_flux(mesh, problem, side);
    const auto add = [&](int v, double moment) {
      VertexFlux& vertex = shared.try_emplace(v, VertexFlux{residual[at(v)], 0.0}).first->second;
      vertex.remainder += moment;
      vertex.length += side.length;
    };
    add(side.from, own.from - in_element.from);
    add(side.to, own.to - in_element.to);
  }
  for (const Side* side : dirichlet) {
    for (const int v : {side->from, side->to}) {
      fluxes[side->label] += shared.at(v).remainder * side->length / shared.at(v).length;
    }
  }
  return fluxes;
}

bool shares_residuals(const Problem& problem, const std::vector<Side>& sides, const std::set<int>& labels) {
  std::map<int, bool> is_inside;  // whether the first side at a vertex has one of the labels
  for (const Side& side : sides) {
    const BoundaryCondition* condition = condition_on(problem, side);
    if (!condition || condition->kind != BoundaryKind::Dirichlet) continue;
    const bool inside = labels.contains(side.label);
    for (const int v : {side.from, side.to})
      if (is_inside.try_emplace(v, inside).first->second != inside) return true;
  }
  return false;
}

}  // namespace parmesan
