#pragma once

#include <vector>

#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// Calls f(e) for every directed edge that has a triangle inside the hull on its left.
template <class F>
void for_each_side(const Triangulation& t, F f) {
  for (std::int32_t index = 0; index < 4 * t.size(); index += 2) {
    const EdgeId e{index};
    if (t.is_alive(undirected(e)) && t.is_inside_left(e)) f(e);
  }
}

/// Repaints faces left of the edges given, and those reached without crossing a constraint, that
/// carry `from`. Returns the edges of constraints met, their unpainted faces on the left.
std::vector<EdgeId> flood(Triangulation& t, std::vector<EdgeId> stack, std::int32_t from, std::int32_t to);

/// Paints all faces: 0 where the hull is reached without crossing a constraint, `unknown` elsewhere. Returns as flood.
std::vector<EdgeId> flood_from_hull(Triangulation& t, std::int32_t unknown);

}  // namespace parmesan
