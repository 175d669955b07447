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

}  // namespace parmesan
