#pragma once

#include <functional>
#include <vector>

#include "mesher/cracks.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The mesh with the vertices on cracks moved 2^-27 of the way to the centroid of one of their triangles: far from
/// rounding, and from what shows in an error. What jumps across a crack has that side's value there. Cost: O(n).
Mesh moved_off_cracks(const Mesh& mesh);

/// f of the mesh, moved off its cracks where it has some.
template <class F>
auto with_open_cracks(const Mesh& mesh, F f) {
  return has_cracks(mesh) ? f(moved_off_cracks(mesh)) : f(mesh);
}

/// Nodal values of the P1 interpolant of a function that may jump across the cracks of the mesh: at a vertex on one
/// side of a crack, its limit from that side.
std::vector<double> nodal_values(const Mesh& mesh, const std::function<double(const Point&)>& f);

}  // namespace parmesan
