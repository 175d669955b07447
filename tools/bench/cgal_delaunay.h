#pragma once

#include <optional>

#include "mesher/geometry/domain.h"
#include "tools/bench/timing.h"

namespace parmesan::bench {

/// CGAL::Delaunay_triangulation_2 of the points; segments are left aside. Making CGAL's points is not
/// timed. Nothing when the program was built without CGAL.
std::optional<Timing> cgal_delaunay(const Domain& domain);

/// CGAL::Constrained_Delaunay_triangulation_2 of points and segments, in the same way.
std::optional<Timing> cgal_constrained(const Domain& domain);

}  // namespace parmesan::bench
