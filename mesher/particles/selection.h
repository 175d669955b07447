#pragma once

#include <vector>

#include "mesher/parallel.h"
#include "mesher/particles/star.h"

namespace parmesan {

/// The free particles v for which selects(star of v, v) is true, in the order of their numbers; on all threads.
template <class F>
std::vector<VertexId> select_free_particles(const ParticleSystem& particles, F selects) {
  const Triangulation& mesh = particles.mesh();
  const auto size = static_cast<std::size_t>(mesh.num_slots());
  return collect<VertexId>(size, [&](std::size_t first, std::size_t last, std::vector<VertexId>& found) {
    Star star;
    for (auto v = static_cast<VertexId>(first); v < static_cast<VertexId>(last); ++v) {
      if (!mesh.has_vertex(v) || !particles.is_free(v)) continue;
      star.gather(particles, v);
      if (selects(star, v)) found.push_back(v);
    }
  });
}

}  // namespace parmesan
