#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"
#include "mesher/triangulation/refine.h"

namespace parmesan {

/// Where the edges of a mesh that belong to curves are to be cut: in the middle of their arcs.
///
/// Shape: the labels of the mesh are segments of the domain. Cost: O(b).
std::vector<EdgeMiddle> middles_on_curves(const Mesh& mesh, const Domain& domain);

/// The mesh with the vertices of edges on curves moved to the nearest points there, unless they are there to rounding;
/// nothing if that turns a triangle over. Labels as above. Cost: O(n).
std::optional<Mesh> put_on_curves(Mesh mesh, const Domain& domain);

/// What is to be said of edges that are farther from their curves than half the height of a triangle beside them: the
/// mesh is not as thin as the domain there. Labels as above. Cost: O(n), O(b log b) for the edges on curves.
std::optional<std::string> distant_chords(const Mesh& mesh, const Domain& domain);

/// Errors: MeshingError when edges cross, or lie on one another. On curves they may, where no triangle lies between
/// them that would turn over. Nothing is looked at in domains without curves. Cost: O(b log b).
void require_no_crossings(const Mesh& mesh, const Domain& domain);

}  // namespace parmesan
