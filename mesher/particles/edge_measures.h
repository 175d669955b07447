#pragma once

#include "mesher/metric/metric_length.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// From the origin of e to its destination.
inline Vector displacement(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  return mesh.point(mesh.dest(e)) - mesh.point(mesh.org(e));
}

/// The mean of the metrics at the corners of the triangle left of e.
inline Metric mean_metric_left(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  return mean(particles.metric(mesh.org(e)), particles.metric(mesh.dest(e)), particles.metric(mesh.left_apex(e)));
}

/// Area of the triangle left of e in that metric (5.10).
inline double left_area(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  return metric_area(mesh.point(mesh.org(e)), mesh.point(mesh.dest(e)), mesh.point(mesh.left_apex(e)),
                     mean_metric_left(particles, e));
}

}  // namespace parmesan
