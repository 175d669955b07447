#include "mesher/triangulation/flood.h"

namespace parmesan {

std::vector<EdgeId> flood(Triangulation& t, std::vector<EdgeId> stack, std::int32_t from, std::int32_t to) {
  std::vector<EdgeId> beyond;
  while (!stack.empty()) {
    const EdgeId e = stack.back();
    stack.pop_back();
    if (t.left(e) != from) continue;
    for (const EdgeId side : {e, t.lnext(e), t.lprev(e)}) {
      t.set_left(side, to);
      if (t.right(side) != from) continue;
      (t.is_constrained(side) ? beyond : stack).push_back(sym(side));
    }
  }
  return beyond;
}

std::vector<EdgeId> flood_from_hull(Triangulation& t, std::int32_t unknown) {
  std::vector<EdgeId> open;
  std::vector<EdgeId> closed;
  for_each_side(t, [&](EdgeId e) {
    t.set_left(e, unknown);
    if (!t.is_inside_right(e)) (t.is_constrained(e) ? closed : open).push_back(e);
  });
  std::vector<EdgeId> met = flood(t, std::move(open), unknown, 0);
  met.insert(met.end(), closed.begin(), closed.end());
  return met;
}

}  // namespace parmesan
