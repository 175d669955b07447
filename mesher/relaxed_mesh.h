#pragma once

#include <optional>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/metric/tensor_field.h"
#include "mesher/particles/fast_schedule.h"
#include "mesher/particles/mesh_observer.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// How a mesh is relaxed by the fast schedule.
struct Relaxation {
  FastScheduleOptions effort;
  const TensorField* hessian = nullptr;  // of a function whose error is lowered last, not owned
  MeshObserver observer = {};
};

/// A mesh, its edges labelled with segments, and what its particles feel.
struct Relaxed {
  Mesh mesh;
  std::vector<Metric> metrics;
  std::optional<Mesh> before_descent;  // the mesh as it was before its error was lowered
};

Relaxed taken_from(const ParticleSystem& particles);

/// The same after the last stage, where there is a function whose error can be lowered.
Relaxed taken_lower_in_error(ParticleSystem& particles, const TensorField* hessian);

/// A mesh whose edges are labelled with segments, refined so many times (refine_red): curved edges on their curves,
/// with what the domain requires.
Mesh refined(Mesh mesh, const Domain& domain, int times = 1);

/// The mesh as particles are swept, in the order of memory.
Mesh in_local_order(Mesh mesh);

}  // namespace parmesan
