#include "mesher/geometry/clean.h"

#include <cstddef>
#include <utility>

#include "mesher/geometry/repair.h"

namespace parmesan {
namespace {

/// Splits segments at points inside them, which takes long among many crossings: what evidently crosses is refused
/// first. Errors: GeometryError for segments that cross.
DomainRepair split_without_crossings(DomainRepair repair) {
  constexpr std::size_t max_crossings = 1000;
  const EvidentCrossings found = evident_crossings(repair, max_crossings);
  refuse_crossings_off_points(repair, found);
  repair = split_at_inner_vertices(std::move(repair));
  if (!found.are_none()) refuse_straight_crossings(repair);
  return repair;
}

}  // namespace

DomainRepair first_stages(const Domain& domain) {
  check_input(domain);
  DomainRepair repair = split_curves(merge_points(domain));
  require_extent(repair);
  return drop_repeated_segments(std::move(repair));
}

CleanDomain clean(const Domain& domain, Crossings crossings) {
  DomainRepair repair = first_stages(domain);
  require_seeds_off_points(repair);
  if (crossings == Crossings::Split) {
    repair = split_at_crossings(std::move(repair));
    refuse_straight_crossings(repair);  // points where curves are split are rounded
  } else {
    repair = split_without_crossings(std::move(repair));
  }
  refuse_curve_conflicts(repair);
  repair = halve_single_cracks(std::move(repair));
  repair = require_enclosure(std::move(repair));
  repair = note_close_points(std::move(repair));
  return {std::move(repair.domain), std::move(repair.repairs)};
}

}  // namespace parmesan
