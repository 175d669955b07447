#pragma once

#include <cstdint>
#include <optional>

#include "adapt/case.h"
#include "adapt/summary.h"

namespace parmesan {

/// What a trial found.
struct Trial {
  IterationRow row;  // of the coarse mesh
  // About what targets.l2_error takes by the limit of interpolation, which runs exceed. Absent without that target, and
  // where the exact function is not known or its limit not meaningful.
  std::optional<double> least_vertices;
};

/// Does what a run does first, on a coarse mesh: meshes the domain, solves and measures. So a case that it stands will
/// not be refused at once by run_case.
///
/// max_vertices: the limit of a run, against which the number aimed at, the first mesh and the mesh that metric.h_max
/// alone asks for are held. Errors: as run_case. Cost: that of 400 vertices at most, more where the geometry needs
/// them.
Trial try_out(const Case& input, std::int64_t max_vertices);

/// About what a run that ends with so many vertices takes of memory, from runs with 20 000 to 100 000. Units: MB.
double expected_memory_mb(const Case& input, std::int64_t vertices);

}  // namespace parmesan
