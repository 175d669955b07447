#include "fem/boundary_extension.h"

#include <optional>

#include "mesher/index.h"

namespace parmesan {

namespace {

constexpr std::size_t min_points = 4;

/// The equations of the linear function at the inner vertices of a patch.
NormalEquations<3> equations_at_inner(const VertexPatch& patch, const std::vector<double>& field) {
  const PatchScaling scaling = covariance_scaling(patch.offsets());
  NormalEquations<3> equations;
  for (std::size_t i = 0; i < patch.offsets().size(); ++i) {
    const int v = patch.vertices()[i];
    if (!patch.is_inner(v)) continue;
    const Vector s = scaling.scaled(patch.offsets()[i]);
    equations.add(patch_weight(s), {1.0, s.x, s.y}, field[at(v)]);
  }
  return equations;
}

std::optional<double> extrapolated(VertexPatch& patch, int vertex, const std::vector<double>& field) {
  patch.start(vertex);
  for (int ring = 1; ring <= VertexPatch::max_rings && patch.grow(); ++ring) {
    const NormalEquations<3> equations = equations_at_inner(patch, field);
    if (equations.rows < min_points) continue;
    if (const auto fit = solution(equations)) return (*fit)[0];
  }
  return std::nullopt;
}

}  // namespace

std::vector<double> extended_to_boundary(VertexPatch& patch, const std::vector<double>& field) {
  std::vector<double> result = field;
  for (std::size_t v = 0; v < field.size(); ++v) {
    const int vertex = static_cast<int>(v);
    if (!patch.is_inner(vertex)) result[v] = extrapolated(patch, vertex, field).value_or(field[v]);
  }
  return result;
}

std::vector<Hessian> extended_to_boundary(VertexPatch& patch, const std::vector<Hessian>& hessians) {
  std::vector<Hessian> result = hessians;
  for (double Hessian::*entry : {&Hessian::xx, &Hessian::xy, &Hessian::yy}) {
    std::vector<double> field;
    field.reserve(hessians.size());
    for (const Hessian& h : hessians) field.push_back(h.*entry);
    field = extended_to_boundary(patch, field);
    for (std::size_t v = 0; v < field.size(); ++v) result[v].*entry = field[v];
  }
  return result;
}

}  // namespace parmesan
