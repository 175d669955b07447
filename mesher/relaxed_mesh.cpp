#include "mesher/relaxed_mesh.h"

#include <numeric>
#include <utility>

#include "mesher/curve_vertices.h"
#include "mesher/particles/curve_chords.h"
#include "mesher/particles/error_descent.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/ordering.h"
#include "mesher/triangulation/refine.h"
#include "mesher/user_labels.h"

namespace parmesan {
namespace {

// While a mesh is made, its edges are labelled with the segment they are a part of.
std::vector<int> segment_numbers(const Domain& domain) {
  std::vector<int> numbers(domain.segments.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace

Relaxed taken_from(const ParticleSystem& particles) {
  ConvertedMesh converted = to_mesh(particles.mesh(), segment_numbers(particles.domain()));
  Relaxed relaxed{.mesh = std::move(converted.mesh), .metrics = {}, .before_descent = {}};
  relaxed.metrics.reserve(converted.slots.size());
  for (const VertexId v : converted.slots) relaxed.metrics.push_back(particles.metric(v));
  return relaxed;
}

Relaxed taken_lower_in_error(ParticleSystem& particles, const TensorField* hessian) {
  if (hessian == nullptr) return taken_from(particles);
  Mesh before = taken_from(particles).mesh;
  lower_error(particles, *hessian);
  split_distant_chords(particles);
  Relaxed relaxed = taken_from(particles);
  relaxed.before_descent = std::move(before);
  return relaxed;
}

Mesh refined(Mesh mesh, const Domain& domain, int times) {
  mesh.required = required_parts(mesh, domain);
  for (int i = 0; i < times; ++i) mesh = refine_red(mesh, middles_on_curves(mesh, domain));
  return mesh;
}

Mesh in_local_order(Mesh mesh) {
  if (is_local(mesh)) return mesh;
  return reordered(mesh, local_order(mesh));
}

}  // namespace parmesan
