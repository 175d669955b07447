#pragma once

#include "mesher/geometry/point.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The smallest rectangle around the mesh, in L.
struct Bounds {
  Point low;
  Point high;
};

/// Errors: InputError when a coordinate, or the extent, is not finite. The unit square for no points.
Bounds bounds_of(const Mesh& mesh);

/// From the plane of the mesh to that of the picture, in pixels, y downwards; equal scales.
struct View {
  Bounds bounds;
  double scale = 1.0;  // pixels per L
  Point corner;        // where bounds.low comes to lie, in pixels

  Point operator()(const Point& p) const {
    return {corner.x + (p.x - bounds.low.x) * scale, corner.y - (p.y - bounds.low.y) * scale};
  }
  double width() const { return (bounds.high.x - bounds.low.x) * scale; }
  double height() const { return (bounds.high.y - bounds.low.y) * scale; }
};

}  // namespace parmesan
