#include "tools/bench/cgal_delaunay.h"

namespace parmesan::bench {

std::optional<Timing> cgal_delaunay(const Domain&) { return std::nullopt; }

std::optional<Timing> cgal_constrained(const Domain&) { return std::nullopt; }

}  // namespace parmesan::bench
