#pragma once

#include <vector>

#include "mesher/generate.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Meshes the domain of a mesh anew, all but its required triangles, which the result has bit for bit: corners, sides,
/// labels and regions.
///
/// What is left of the mesh without them is the domain, the sides in between are its required segments, and the start
/// where generate() finds that near enough to the metric. The diagnosis counts required triangles and their sides under
/// MisfitReason::Required. Errors: GeometryError unless validate() accepts the mesh; as generate(). Cost: O(n).
GenerateResult generate_around(const Mesh& mesh, const MetricField& field, const GenerateOptions& options = {});

/// The mesh with the triangles of these regions required, too.
Mesh with_required_regions(Mesh mesh, const std::vector<int>& regions);

}  // namespace parmesan
