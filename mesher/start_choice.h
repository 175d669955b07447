#pragma once

#include <string>
#include <string_view>

#include "mesher/mesh.h"
#include "mesher/metric/metric_field.h"

namespace parmesan {

/// What a mesh is started from.
enum class Start { Scratch, PreviousMesh, RefinedPreviousMesh };

/// The name used in summary.json, e.g. "refined_previous_mesh".
std::string_view to_string(Start start);

/// How to make use of a previous mesh.
struct StartChoice {
  Start start = Start::Scratch;
  int refinements = 0;             // red, of the previous mesh, before its particles are taken
  double expected_vertices = 0.0;  // of the mesh to be made, where it starts from the previous one
  std::string reason;              // with the measurement that decided
};

/// Is the previous mesh, perhaps red-refined, near enough to a unit mesh of the field to start from?
///
/// It is when mean |ln(l / 2^k)| over its edges is under 0.15, l being their metric lengths and k the number of
/// refinements that brings their geometric mean nearest to 1, and that mean is off by less than 0.05, a tenth of the
/// number of vertices. Beyond, a start from scratch takes less time and ends at least as well (measured: see
/// mesher/README.md).
/// Cost: three metrics in each of at most 1000 triangles, evenly picked.
StartChoice choose_start(const Mesh& previous, const MetricField& field);

}  // namespace parmesan
