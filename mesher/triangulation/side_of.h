#pragma once

#include "mesher/geometry/predicates.h"
#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// Positive when p lies to the left of e, zero on its line, with exact sign.
inline double side_of(const Triangulation& t, EdgeId e, const Point& p) {
  return orient2d(t.point(t.org(e)), t.point(t.dest(e)), p);
}

}  // namespace parmesan
