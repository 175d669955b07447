#pragma once

#include <string>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan::oracle {

/// All that is wrong with a mesh, found without any code of the mesher; empty when nothing is.
///
/// Finite points, indices, counter-clockwise triangles (exact), conformity (a side belongs to at most
/// two triangles, in opposite directions; no vertex inside a boundary side), no orphan vertex,
/// boundary = labelled edges with the domain to their left, angles around each vertex of at most one
/// turn, and Euler's formula V - E + F = 2 parts - boundary loops, vertices counted once per fan.
/// Cost: O(n log n + b^2), b boundary edges.
std::vector<std::string> problems_of(const Mesh& mesh);

/// Sum of the triangles' areas, in long double.
double area_of(const Mesh& mesh);

}  // namespace parmesan::oracle
