#include "mesher/io/picture/view.h"

#include <algorithm>
#include <cmath>

#include "mesher/errors.h"

namespace parmesan {

Bounds bounds_of(const Mesh& mesh) {
  if (mesh.points.empty()) return {{0.0, 0.0}, {1.0, 1.0}};
  Bounds bounds{mesh.points.front(), mesh.points.front()};
  for (const Point& p : mesh.points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw InputError("a mesh with infinite points cannot be drawn");
    bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y)};
    bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y)};
  }
  const Vector extent = bounds.high - bounds.low;
  if (!std::isfinite(extent.x) || !std::isfinite(extent.y)) throw InputError("the mesh is too large to be drawn");
  return bounds;
}

}  // namespace parmesan
