#include "fem/contradicting_data.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "fem/boundary_conditions.h"
#include "fem/coefficients.h"
#include "fem/side_integrals.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// A number found by extrapolation, and by how much it may be wrong.
struct Extrapolated {
  double value = 0.0;
  double doubt = 0.0;
};

/// What a side asks of the gradient at one of its ends: direction.grad u = flux - coefficient u, the direction of
/// length 1 in the metric K^-1.
struct Demand {
  Diffusion diffusion;  // K, the same for all sides of a vertex
  Vector direction;
  Extrapolated flux;
  double coefficient = 0.0;
  std::optional<double> given;  // u, where the side has it

  double flux_at(double u) const { return flux.value - coefficient * u; }
};

/// An end of a side and what is looked at there: points beside the vertex, as data may jump at it.
struct SideEnd {
  const Side& side;
  Point vertex;
  Vector along;  // from the vertex, of the side's length

  static constexpr double step = 1e-3;  // of the side
  Point beside(double steps) const { return vertex + (steps * step) * along; }

  Extrapolated value_of(const BoundaryData& g) const {
    const double first = data_at(g, side, beside(1.0)), second = data_at(g, side, beside(2.0));
    return {2.0 * first - second, std::abs(first - second)};
  }

  /// The derivative along the side, times its length.
  Extrapolated rise_of(const BoundaryData& g) const {
    constexpr double roundoff = 1e-13;
    const double at_vertex = data_at(g, side, vertex), first = data_at(g, side, beside(1.0));
    const double near = (first - at_vertex) / step, far = (data_at(g, side, beside(2.0)) - first) / step;
    return {1.5 * near - 0.5 * far, std::abs(near - far) + roundoff / step * std::abs(at_vertex)};
  }
};

Diffusion inverse(const Diffusion& k) {
  const double det = determinant(k);
  return {k.yy / det, -k.xy / det, k.xx / det};
}

Demand with_unit_direction(Demand demand) {
  const double scale = 1.0 / std::sqrt(quadratic_form(inverse(demand.diffusion), demand.direction));
  demand.direction = scale * demand.direction;
  demand.flux = {scale * demand.flux.value, scale * demand.flux.doubt};
  demand.coefficient *= scale;
  return demand;
}

Demand demand_of(const SideEnd& end, const BoundaryCondition& condition, const Diffusion& k) {
  Demand demand{
      .diffusion = k, .direction = k * end.side.normal, .flux = {}, .coefficient = 0.0, .given = std::nullopt};
  if (condition.kind == BoundaryKind::Dirichlet) {
    demand.direction = end.along;
    demand.flux = end.rise_of(condition.value);
    demand.given = data_at(condition.value, end.side, end.vertex);
  } else {
    demand.flux = end.value_of(condition.value);
    if (condition.kind == BoundaryKind::Robin) demand.coefficient = end.value_of(condition.coefficient).value;
  }
  return with_unit_direction(demand);
}

/// largest: of the fluxes that are asked for anywhere.
bool contradict(const Demand& one, const Demand& two, double largest) {
  constexpr double share = 1e-3;       // of the fluxes at the vertex
  constexpr double negligible = 1e-6;  // of the largest
  constexpr double growth = 4.0;       // of the gradient over the largest flux
  const Diffusion metric = inverse(one.diffusion);
  const double sign = dot(one.direction, metric * two.direction) < 0.0 ? -1.0 : 1.0;
  const double turn = std::sqrt(quadratic_form(metric, one.direction - sign * two.direction));
  const std::optional<double> given = one.given ? one.given : two.given;
  const double u = given.value_or(0.0);
  const double a = one.flux_at(u), b = sign * two.flux_at(u);
  const double size = std::max(std::abs(a), std::abs(b));
  const double explained = growth * turn * std::max(size, largest) + one.flux.doubt + two.flux.doubt;
  if (std::abs(a - b) > share * size + negligible * largest + explained) return true;
  const double c = one.coefficient, d = sign * two.coefficient;
  return !given && std::abs(c - d) > (share + growth * turn) * std::max(std::abs(c), std::abs(d));
}

}  // namespace

std::vector<char> contradicting_data(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides) {
  std::map<int, std::vector<Demand>> demands;  // at the vertices
  double largest = 0.0;
  for (const Side& side : sides) {
    const BoundaryCondition* condition = condition_on(problem, side);
    if (!condition) continue;
    for (const auto& [v, other] : {std::pair{side.from, side.to}, std::pair{side.to, side.from}}) {
      const Point& p = mesh.points[at(v)];
      const SideEnd end{side, p, mesh.points[at(other)] - p};
      std::vector<Demand>& all = demands[v];
      const Diffusion k = all.empty() ? diffusion_at(problem, end.beside(1.0), side.region) : all.front().diffusion;
      all.push_back(demand_of(end, *condition, k));
      largest = std::max(largest, std::abs(all.back().flux.value));
    }
  }
  std::vector<char> result(mesh.points.size(), 0);
  for (const auto& [v, all] : demands)
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (contradict(all[i], all[j], largest)) result[at(v)] = 1;
  return result;
}

}  // namespace parmesan
