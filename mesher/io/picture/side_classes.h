#pragma once

#include <vector>

#include "mesher/io/picture/picture_path.h"
#include "mesher/io/picture/view.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Sides of triangles that are drawn with lines of the same width.
struct SideClass {
  double width_px = 0.0;
  PicturePath path;
};

/// The sides of all triangles, each once. With a the smallest altitude of the triangles beside it a
/// line is about sqrt(a) / 4 pixels wide, from 0.1 to 0.85: fine parts get darker without being
/// drowned in ink. The altitudes are rounded to powers of sqrt(2), so there are few classes. Cost: O(n log n).
std::vector<SideClass> side_classes(const Mesh& mesh, const View& view);

}  // namespace parmesan
