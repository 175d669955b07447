#pragma once

#include "mesher/metric/metric_length.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// Area of the triangle left of e in the mean of its vertex metrics (5.10).
inline double left_area(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  const VertexId a = mesh.org(e);
  const VertexId b = mesh.dest(e);
  const VertexId c = mesh.dest(mesh.onext(e));
  return metric_area(mesh.point(a), mesh.point(b), mesh.point(c),
                     mean(particles.metric(a), particles.metric(b), particles.metric(c)));
}

}  // namespace parmesan
