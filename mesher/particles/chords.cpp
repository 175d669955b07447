#include "mesher/particles/chords.h"

#include "mesher/metric/metric_length.h"
#include "mesher/particles/edge_measures.h"
#include "mesher/particles/local_repair.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/star.h"
#include "mesher/triangulation/star.h"

namespace parmesan {
namespace {

constexpr double longest_unit = 1.414;  // sqrt2, but for rounding

double length(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  return metric_edge_length(displacement(particles, e), particles.metric(mesh.org(e)), particles.metric(mesh.dest(e)));
}

bool is_long_chord(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  if (mesh.is_constrained(e) || particles.is_free(mesh.org(e)) || particles.is_free(mesh.dest(e))) return false;
  return length(particles, e) > longest_unit;
}

// Moves a particle to the best place near by. Are its edges unit edges there, and its triangles good?
bool settles(ParticleSystem& particles, VertexId v) {
  constexpr int max_moves = 3;
  constexpr double good = 0.7;
  Star star;
  star.gather(particles, v);
  for (int i = 0; i < max_moves; ++i) particles.move(v, best_place_near(particles, star, v));
  bool is_unit = true;
  for_each_spoke(particles.mesh(), v, [&](EdgeId e) {
    const double l = length(particles, e);
    is_unit = is_unit && l <= longest_unit && l * longest_unit >= 1.0;
  });
  return is_unit && star.min_quality(particles.mesh().point(v), particles.metric(v)) >= good;
}

bool mend_by_flip(ParticleSystem& particles, EdgeId e) {
  Triangulation& mesh = particles.mesh();
  if (!can_flip(mesh, e)) return false;
  for (const VertexId v : {mesh.left_apex(e), mesh.right_apex(e)}) {
    if (!particles.is_free(v)) continue;
    const Point from = mesh.point(v);
    mesh.flip(e);
    if (settles(particles, v)) return true;
    particles.move(v, from);
    mesh.flip(e);
  }
  return false;
}

void mend_by_cut(ParticleSystem& particles, EdgeId e) {
  Triangulation& mesh = particles.mesh();
  const VertexId end = mesh.org(e);
  const Point middle = midpoint(mesh.point(end), mesh.point(mesh.dest(e)));
  if (obstacle_to_split(mesh, e, middle) != no_vertex) return;
  const VertexId v = particles.create_on_edge(e, middle);
  if (!settles(particles, v)) mesh.collapse(sym(e));  // e is now the half at its origin
}

}  // namespace

void mend_chords(ParticleSystem& particles) {
  const std::int32_t num_edges = particles.mesh().size();
  for (std::int32_t q = 0; q < num_edges; ++q) {
    const EdgeId e{4 * q};
    if (!particles.mesh().is_alive(q) || !is_long_chord(particles, e)) continue;
    if (!mend_by_flip(particles, e)) mend_by_cut(particles, e);
  }
}

}  // namespace parmesan
