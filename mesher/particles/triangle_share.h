#pragma once

#include <algorithm>
#include <cmath>

#include "mesher/particles/edge_measures.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// As how many triangles the rules of population count the one left of e.
///
/// Where a domain gives more detail than the metric asks for, its sides are shorter than unit edges, and fans of small
/// triangles stand on them: the areas of 3.4.2 would let no particle in. One on a constrained edge of length l under
/// 1/sqrt2 counts as l triangles, any other as one.
inline double share_left(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  double shortest = 1.0;
  EdgeId side = e;
  for (int i = 0; i < 3; ++i, side = mesh.lnext(side)) {
    if (!mesh.is_constrained(side)) continue;
    const double squared = squared_length_in_mean(displacement(particles, side), particles.metric(mesh.org(side)),
                                                  particles.metric(mesh.dest(side)));
    if (squared < 0.5) shortest = std::min(shortest, std::sqrt(squared));
  }
  return shortest;
}

}  // namespace parmesan
