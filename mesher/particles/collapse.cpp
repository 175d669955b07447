#include "mesher/particles/collapse.h"

#include <algorithm>

#include "mesher/particles/triangle_share.h"

namespace parmesan {

namespace {

// Those on short sides are thin whatever happens.
double smallest_share(const ParticleSystem& particles, const Star& star) {
  double smallest = 1.0;
  for (std::size_t i = 0; i < star.size(); ++i)
    smallest = std::min(smallest, share_left(particles, star.spoke(i).edge));
  return smallest;
}

}  // namespace

bool can_collapse(const ParticleSystem& particles, const Star& star, VertexId v, EdgeId e) {
  constexpr double min_quality_after = 0.1;  // of the triangles that it stretches
  const double after = star.quality_after_collapse(star.index_of(e));
  if (after >= min_quality_after) return true;
  return after > 0.0 && (after >= min_quality_after * smallest_share(particles, star) ||
                         after >= star.min_quality(particles.mesh().point(v), particles.metric(v)));
}

bool keeps_constraints_apart(const Triangulation& mesh, EdgeId e) {
  for (const EdgeId side : {e, sym(e)}) {
    const EdgeId second = mesh.lnext(side);
    const EdgeId third = mesh.lnext(second);
    if (mesh.lnext(third) == side && mesh.is_constrained(second) && mesh.is_constrained(third)) return false;
  }
  return true;
}

bool collapse_if_valid(ParticleSystem& particles, EdgeId e) {
  Triangulation& mesh = particles.mesh();
  if (!keeps_constraints_apart(mesh, e)) return false;
  Star star;
  for (const EdgeId side : {e, sym(e)}) {
    const VertexId v = mesh.org(side);
    const Binding binding = particles.binding(v);
    const bool may_go = binding == free_particle || (binding >= 0 && mesh.segment(side) == binding);
    if (!may_go) continue;
    star.gather(particles, v);
    if (!can_collapse(particles, star, v, side)) continue;
    mesh.collapse(side);
    return true;
  }
  return false;
}

}  // namespace parmesan
