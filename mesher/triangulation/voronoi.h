#pragma once

#include <span>
#include <vector>

#include "mesher/geometry/point.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The part of a Voronoi diagram inside a rectangle.
struct VoronoiDiagram {
  std::vector<Point> sites;
  std::vector<std::vector<Point>> cells;  // of each site, convex, counter-clockwise; empty for a repeated site
};

/// The Voronoi diagram of the sites in the rectangle around them, widened by a 20th of its longer side.
///
/// It is the dual of their Delaunay triangulation: the cell of a site is cut out of the rectangle by one bisector for
/// each of the Delaunay edges at it. Errors: GeometryError for fewer than three non-collinear sites. Cost: O(n log n).
VoronoiDiagram voronoi_diagram(std::span<const Point> sites);

/// The cells as a mesh: each a fan of triangles around its site, whose number is their region; the outlines are its
/// labelled edges. For writing to files.
Mesh mesh_of(const VoronoiDiagram& diagram);

}  // namespace parmesan
