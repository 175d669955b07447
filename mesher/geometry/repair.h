#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/geometry/segment_contacts.h"
#include "mesher/index.h"
#include "mesher/number_text.h"

namespace parmesan {

/// Where the user has a segment, counted from 0.
struct SegmentSource {
  int number = 0;
  std::vector<int> repeated = {};  // the numbers of those that were dropped because they lie on it

  /// Ascending.
  std::vector<int> all() const {
    std::vector<int> numbers(repeated);
    numbers.push_back(number);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }
};

/// What messages call a point or a segment of the domain that the user gave.
inline std::string number_text(const Domain& domain, int index) { return text(index + domain.first_number); }

/// A domain under repair. The sources are the places of its points and segments in what the user gave, whose numbers
/// messages use. The stages below take it and return it repaired.
struct DomainRepair {
  Domain domain;
  std::vector<int> point_sources;
  std::vector<SegmentSource> segment_sources;
  std::vector<std::string> repairs;

  const Point& point(int i) const { return domain.points[at(i)]; }
  const Segment& segment(int s) const { return domain.segments[at(s)]; }
  int source_point(int i) const { return point_sources[at(i)]; }
  int source_segment(int s) const { return segment_sources[at(s)].number; }
  std::string point_text(int i) const { return number_text(domain, source_point(i)); }
  std::string segment_text(int s) const { return number_text(domain, source_segment(s)); }

  /// The number of the next point that is made, after the user's. Cost: O(n).
  int next_source_point() const;

  /// Adds "merged 7 duplicate points: a, b, c, d, e, and 2 more", or nothing without items.
  void note(std::string_view verb, std::string_view noun, const std::vector<std::string>& items);
};

/// The straight ones of some segments, in their order.
struct StraightSegments {
  explicit StraightSegments(const std::vector<Segment>& all) {
    for (int s = 0; s < static_cast<int>(all.size()); ++s) {
      if (!all[at(s)].is_straight()) continue;
      segments.push_back(all[at(s)]);
      numbers.push_back(s);
    }
  }
  int index(int straight) const { return numbers[at(straight)]; }

  std::vector<Segment> segments;
  std::vector<int> numbers;
};

// The stages of clean(), in its order.

/// Errors: GeometryError for indices out of range, coordinates that are not finite, a negative tolerance; InputError
/// for coordinates over 1e75.
void check_input(const Domain& domain);

/// Begins the repair of a domain, and applies its tolerance if it has one, or merges equal points (see below).
/// Errors: as of these.
DomainRepair merge_points(const Domain& domain);

/// Splits curved segments in the middle if they end where they begin, at kinks, and at points on them.
/// Errors: GeometryError for a segment whose curve does not begin and end at its points, and for a seed on a curve.
DomainRepair split_curves(DomainRepair repair);

/// Errors: GeometryError for fewer than three points or all on one line; InputError for a diameter under 1e-75.
void require_extent(const DomainRepair& repair);

/// Drops segments of no length, and those that join the same points as an earlier one.
DomainRepair drop_repeated_segments(DomainRepair repair);

/// The stages so far. Errors: as of these.
DomainRepair first_stages(const Domain& domain);

/// Errors: GeometryError for a seed at a point.
void require_seeds_off_points(const DomainRepair& repair);

/// Crossings of straight segments, by the numbers of these, found in bounded time: as the search among segments.
EvidentCrossings evident_crossings(const DomainRepair& repair, std::size_t max_crossings);

/// Looks at the first 20 that were found. A crossing in a point of the domain is none, once both segments are split
/// there. Errors: GeometryError for segments that cross elsewhere, with both and the point.
void refuse_crossings_off_points(const DomainRepair& repair, const EvidentCrossings& found);

/// Replaces each segment that has points inside by the chain through them.
/// Errors: GeometryError for a seed on a segment.
DomainRepair split_at_inner_vertices(DomainRepair repair);

/// Errors: GeometryError for segments that cross, with both and the point.
void refuse_straight_crossings(const DomainRepair& repair);

/// Errors: GeometryError for curved segments that cross others or touch them.
void refuse_curve_conflicts(const DomainRepair& repair);

/// Gives a crack of one segment a point in its middle, unless another goes on: one edge alone might not open.
/// Errors: GeometryError for one between free ends that is required to stay one edge.
DomainRepair halve_single_cracks(DomainRepair repair);

/// Notes chains that end freely. Errors: GeometryError, with an open end, when nothing is enclosed.
DomainRepair require_enclosure(DomainRepair repair);

/// Notes the two nearest points, or the point that is nearest beside a straight segment, if they are under 1e-7 of the
/// diameter or 16 ulp apart.
DomainRepair note_close_points(DomainRepair repair);

// The stages of subdivide(), after the first; clean() takes the same where crossings are to be split.

/// Splits segments at points inside them and where they cross, until no crossing is left: rounded crossing points turn
/// the pieces a little, which may make them cross others. No rounding is known that ends for sure, so rounds are
/// counted. Curves are split where they cross or touch other segments, but not themselves.
/// Errors: GeometryError for a million crossings, and as split_at_inner_vertices.
DomainRepair split_at_crossings(DomainRepair repair);

/// The planar subdivision of a domain without seeds: the first stages, and then crossings are split.
/// Errors: as of these.
DomainRepair subdivide(const Domain& domain);

// Parts of the stages.

/// A copy without a merge tolerance; each point and segment is its own source. The notes become the first repairs.
DomainRepair begin_repair(const Domain& domain);

/// Equal points become the first of them, and points near the end of a curve to rounding become that; the order of the
/// others stays.
DomainRepair merge_equal_points(DomainRepair repair);

/// Points nearer than the tolerance become the first of them, ends of curves before others; the order of the others
/// stays. Straight segments are bent to points as near, and pairs of them that come to be joined may go. given: the
/// domain that is under repair, of which nothing was changed yet.
/// Errors: GeometryError for a seed of a hole or region that is nearer than the tolerance to a straight segment, once
/// points are merged or segments bent by it.
DomainRepair apply_merge_tolerance(DomainRepair repair, const Domain& given);

/// Replaces each straight segment by the chain through the points beside it that are nearer than the tolerance to it as
/// it was given, but for required ones. Of two that are beside one place of it the nearer counts. given: the domain
/// that is under repair, whose segments are all there yet. Cost: O(n log n) expected.
DomainRepair bend_to_near_points(DomainRepair repair, const Domain& given);

/// Where the inside is what an odd number of segments separates from infinity, two that have come to lie on one another
/// separate nothing, and both go. given: the domain that is under repair.
DomainRepair drop_joined_pairs(DomainRepair repair, const Domain& given);

/// Replaces each segment by the chain through points along it, in their order from a to b; one that is where the chain
/// has come to makes no piece. Shape: along is one list for each segment.
DomainRepair split_along(DomainRepair repair, const std::vector<std::vector<int>>& along);

/// Whether the curve of a segment begins and ends at its points, to 1e-9 of its extent, or the whole's for pieces, or
/// 16 ulp.
bool ends_meet(const Domain& domain, const Segment& segment);

/// As split_curves without the checks, once they are made.
DomainRepair cut_curves(DomainRepair repair);

/// Curves that run together from one end to the other become one, as segments that join the same points do.
DomainRepair merge_equal_curves(DomainRepair repair);

/// Where two segments cross, rounded.
Point crossing_of(const DomainRepair& repair, int s, int t);

}  // namespace parmesan
