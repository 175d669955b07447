#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// A labelled edge of the mesh seen from the triangle to its left.
///
///            apex            normal points to the right of from -> to,
///           /    \           out of the triangle.
///       from ---> to
struct Side {
  int from = 0;
  int to = 0;
  int label = 0;
  int triangle = 0;         // to the left
  int region = 0;           // of the triangle
  int other_triangle = -1;  // to the right, where there is one
  int other_region = 0;     // of that
  Vector normal;            // of length 1
  double length = 0.0;      // L
  double arc_height = 0.0;  // how far the arc it stands for is from its middle, along the normal; L
  bool interior = false;    // triangles on both sides: an interior constraint
};

/// The labelled edges in the order of mesh.edges. Interior constraints are seen from the left.
/// arc_heights: how far the arcs that labelled edges stand for are from their middles, to the right of them, or none.
/// Errors: GeometryError for an edge that is the side of no triangle.
std::vector<Side> labelled_sides(const Mesh& mesh, std::span<const double> arc_heights = {});

/// Which corner of a triangle beside the side is not on it.
std::size_t apex_of(const Mesh& mesh, const Side& side, int triangle);

}  // namespace parmesan
