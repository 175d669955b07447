#pragma once

#include "mesher/geometry/point.h"

namespace parmesan::oracle {

/// Sign (-1, 0, 1) of the doubled area of triangle abc, by integer arithmetic on the scaled coordinates.
int orientation(const Point& a, const Point& b, const Point& c);

/// Sign (-1, 0, 1) of the 4 x 4 in-circle determinant with rows (x, y, x^2 + y^2, 1); 1 when d lies inside.
int in_circle(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace parmesan::oracle
