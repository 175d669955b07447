#pragma once

#include <numbers>
#include <span>

#include "mesher/mesh.h"
#include "mesher/metric/metric_field.h"

namespace parmesan {

/// Integral of sqrt(det M) of a field over a mesh: a unit mesh has 2 / sqrt3 times as many vertices.
///
/// A mesh of more than 1000 triangles is taken to resolve the field: its corners are sampled. The
/// triangles of a coarser one are cut into four until the midpoint rule settles within 2 %, or they
/// hold less than one unit cell; the first three cuts are always made. Cost: O(n + result) at worst.
/// Errors: see require_usable.
double integrate_complexity(const Mesh& mesh, const MetricField& field);

/// The same of one metric per vertex of the mesh; each triangle has the mean of its corners' densities. Cost: O(n).
double integrate_complexity(const Mesh& mesh, std::span<const Metric> metrics);

/// Vertices of a unit mesh of that complexity, boundary effects aside; and the other way.
constexpr double expected_vertices(double complexity) { return 2.0 * std::numbers::inv_sqrt3 * complexity; }
constexpr double complexity_for_vertices(double vertices) { return 0.5 * std::numbers::sqrt3 * vertices; }

}  // namespace parmesan
