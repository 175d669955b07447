#pragma once

#include <cstdint>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"
#include "mesher/metric/metric_field.h"
#include "mesher/particles/overlooked.h"
#include "mesher/relaxed_mesh.h"

namespace parmesan {

/// The mesh of the domain's sites, with more of them where these do not show what the metric asks for.
struct ScratchStart {
  Mesh mesh;
  OverlookedParts overlooked;
  double held;  // complexity of the field's samples
  double expected_vertices;
};

/// sites: the mesh of the domain's sites, its edges labelled with segments. Errors: LimitError when the metric asks for
/// more than max_vertices.
ScratchStart scratch_start(const Domain& domain, Mesh sites, const MetricField& field, std::int64_t max_vertices);

/// Relaxed level by level, each with four times the vertices of the one before; once more with more sites, where a spot
/// is not in the mesh since no particle came to see it.
Relaxed mesh_from_scratch(const Domain& domain, const MetricField& field, ScratchStart start,
                          const Relaxation& relaxation);

}  // namespace parmesan
