#pragma once

#include "mesher/particles/particle_system.h"
#include "mesher/triangulation/conversion.h"
#include "tests/support/meshes.h"

namespace parmesan::support {

/// Particles at the corners of n x n squares, each cut into two triangles, over the unit square.
inline ParticleSystem grid_particles(int n, const Domain& domain, const MetricField& field) {
  const Mesh mesh = rectangle_mesh(n, n);
  return ParticleSystem(from_mesh(mesh, segments_of(mesh)), domain, field);
}

}  // namespace parmesan::support
