#include "fem/vertex_patch.h"

#include <cmath>

#include "mesher/index.h"

namespace parmesan {

PatchFit unscaled(const Vector& gradient, const Hessian& hessian, const PatchScaling& scaling) {
  const double a = 1.0 / scaling.g11;
  const double c = 1.0 / scaling.g22;
  const double b = -scaling.g21 * a * c;  // G^-1 = [a 0; b c]
  PatchFit fit;
  fit.gradient = {a * gradient.x + b * gradient.y, c * gradient.y};
  fit.hessian = {a * a * hessian.xx + 2.0 * a * b * hessian.xy + b * b * hessian.yy,
                 c * (a * hessian.xy + b * hessian.yy), c * c * hessian.yy};
  return fit;
}

VertexPatch::VertexPatch(const Mesh& mesh)
    : mesh_(mesh), neighbours_(vertex_neighbours(mesh)), inner_(mesh.points.size()), mark_(mesh.points.size(), 0) {
  std::vector<std::size_t> triangles(mesh.points.size(), 0);
  for (const auto& triangle : mesh.triangles) {
    for (const int v : triangle) ++triangles[at(v)];
  }
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const auto k = static_cast<std::size_t>(v);
    inner_[k] = neighbours_.of(v).size() == triangles[k];  // the boundary has one neighbour more
  }
}

void VertexPatch::start(int vertex) {
  vertices_.assign(1, vertex);
  offsets_.assign(1, Vector{});
  mark_[at(vertex)] = ++stamp_;
  ring_begin_ = 0;
}

bool VertexPatch::grow() {
  const Point& c = mesh_.points[at(centre())];
  const std::size_t end = vertices_.size();
  for (std::size_t i = ring_begin_; i < end; ++i) {
    for (const int w : neighbours_.of(vertices_[i])) {
      if (holds(w)) continue;
      mark_[at(w)] = stamp_;
      vertices_.push_back(w);
      offsets_.push_back(mesh_.points[at(w)] - c);
    }
  }
  ring_begin_ = end;
  return vertices_.size() > end;
}

PatchScaling covariance_scaling(std::span<const Vector> offsets) {
  double xx = 0.0;
  double xy = 0.0;
  for (const Vector& d : offsets) {
    xx += d.x * d.x;
    xy += d.x * d.y;
  }
  const auto n = static_cast<double>(offsets.size());
  PatchScaling g;
  g.g11 = std::sqrt(xx / n);
  if (!(g.g11 > 0.0)) g.g11 = 1.0;
  g.g21 = xy / n / g.g11;
  double rest = 0.0;  // summed after the projection: no digits lost on stretched patches
  for (const Vector& d : offsets) {
    const double y = d.y - g.g21 / g.g11 * d.x;
    rest += y * y;
  }
  g.g22 = std::sqrt(rest / n);
  if (!(g.g22 > 0.0)) g.g22 = 1.0;
  return g;
}

double patch_weight(const Vector& scaled) {
  constexpr double decay = 0.5;
  return std::exp(-decay * squared_norm(scaled));
}

}  // namespace parmesan
