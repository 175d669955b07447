#pragma once

#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// Whether any segment runs along a curve.
bool has_curves(const Domain& domain);

/// The point of a segment at a parameter from 0, its end a, to 1, its end b: on the straight line, or on its curve.
Point point_on(const Domain& domain, const Segment& segment, double t);

/// Its derivative by the parameter.
Vector derivative_on(const Domain& domain, const Segment& segment, double t);

/// The parameter of the point of the segment that is nearest to p; on a straight one also beyond the ends.
double parameter_on(const Domain& domain, const Segment& segment, const Point& p);

/// How far from a curve a point near p may be to be taken for one of it: 1e-9 of its extent, for pieces that of the
/// curve they were cut from, whose ends they have; where it is small and coordinates are large 16 ulp of these.
double reach(const Curve& curve, const Point& p);

/// Does it lead against the direction of the segment, from one of its points to another?
bool is_against(const Domain& domain, const Segment& segment, const Point& from, const Point& to);

/// The direction in which a segment leaves one of its ends; of any length.
Vector direction_from(const Domain& domain, const Segment& segment, int end);

/// Points along a segment, from a to b: its ends, and on a curve as many more as it takes to turn by 10 degrees at
/// most.
std::vector<Point> points_along(const Domain& domain, const Segment& segment);

/// All points of a domain, and points along its curves.
std::vector<Point> points_around(const Domain& domain);

}  // namespace parmesan
