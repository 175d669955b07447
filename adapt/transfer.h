#pragma once

#include <span>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// Values at the vertices of `to` of the P1 function with these nodal values on `from`, found by
/// walking from one vertex's triangle to the next one's. Where a vertex of `to` lies outside of
/// `from`, the nearest place of the mesh decides, so values never leave the range of the old ones.
///
/// Errors: InputError unless there is one value per vertex of `from` and it has triangles.
/// Cost: O(n) when neighbouring vertices have neighbouring numbers.
std::vector<double> transfer(const Mesh& from, std::span<const double> values, const Mesh& to);

}  // namespace parmesan
