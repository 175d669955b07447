#include "mesher/geometry/clean.h"

#include <utility>

#include "mesher/geometry/repair.h"

namespace parmesan {

DomainRepair first_stages(const Domain& domain) {
  check_input(domain);
  DomainRepair repair = split_curves(merge_points(domain));
  require_extent(repair);
  return drop_repeated_segments(std::move(repair));
}

CleanDomain clean(const Domain& domain, Crossings crossings) {
  DomainRepair repair = first_stages(domain);
  require_seeds_off_points(repair);
  const bool none_cross = refuse_evident_crossings(repair, crossings);
  repair = split_at_inner_vertices(std::move(repair));
  if (crossings == Crossings::Split) repair = split_at_crossings(std::move(repair));
  const bool may_cross = !none_cross || crossings == Crossings::Split;  // points where curves are split are rounded
  if (may_cross) refuse_straight_crossings(repair);
  refuse_curve_conflicts(repair);
  repair = halve_single_cracks(std::move(repair));
  repair = require_enclosure(std::move(repair));
  repair = note_close_points(std::move(repair));
  return {std::move(repair.domain), std::move(repair.repairs)};
}

}  // namespace parmesan
