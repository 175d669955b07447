#include "mesher/set_operation.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesher/disjoint_sets.h"
#include "mesher/errors.h"
#include "mesher/geometry/outline.h"
#include "mesher/geometry/repair.h"
#include "mesher/index.h"
#include "mesher/number_text.h"
#include "mesher/operands.h"
#include "mesher/triangulation/face_walks.h"
#include "mesher/triangulation/faces.h"

namespace parmesan {
namespace {

DomainRepair subdivide_without_seeds(Domain domain) {
  domain.regions.clear();
  return subdivide(domain);
}

struct Result {
  Domain domain;
  std::vector<char> is_border;  // of each segment; the others lie inside
};

/// The planar subdivision of the operands, and what of it is in the result.
class Arrangement {
 public:
  Arrangement(SetOperation operation, const Operands& operands, DomainRepair subdivision)
      : operands_(operands), subdivision_(std::move(subdivision)), faces_(subdivision_.domain) {
    find_faces(operation);
    for (int s = 0; s < faces_.num_segments(); ++s) sources_kept_.push_back(source_kept(s));
    find_groups();
    find_regions();
  }

  Result result() const;

 private:
  /// The segments of the operands that run along one of the subdivision.
  std::vector<int> sources(int segment) const { return subdivision_.segment_sources[at(segment)].all(); }

  bool is_of(int owner, int segment) const {
    const std::vector<int> all = sources(segment);
    return std::any_of(all.begin(), all.end(), [&](int source) { return operands_.owners[at(source)] == owner; });
  }

  void find_faces(SetOperation operation);
  std::optional<int> source_kept(int segment) const;
  void find_groups();
  void find_regions();
  void give_region(int face, int region);
  Segment labelled(int segment, int source) const;
  std::vector<FacePoint> points_in_groups() const;
  void add_holes(const std::vector<FacePoint>& points, Domain& domain) const;
  void add_regions(const std::vector<FacePoint>& points, Domain& domain) const;

  const Operands& operands_;
  DomainRepair subdivision_;
  Faces faces_;
  std::vector<char> is_in_result_;                // of each face
  std::vector<std::optional<int>> sources_kept_;  // of each segment in the result: that whose label it has
  std::vector<int> groups_;     // of each face: the lowest of those that no segment of the result parts from it
  std::map<int, int> regions_;  // of groups in the result
};

void Arrangement::find_faces(SetOperation operation) {
  std::vector<int> num_around(at(faces_.count()), 0);  // operands that a face is inside of
  std::vector<char> is_in_first(num_around.size(), 0);
  std::vector<char> is_inside(at(operands_.count), 0);  // of each operand, where the walk is
  int num_inside = 0;
  const auto cross = [&](int segment) {
    for (const int source : sources(segment)) {
      if (operands_.is_border[at(source)] == 0) continue;
      char& inside = is_inside[at(operands_.owners[at(source)])];
      num_inside += inside == 0 ? 1 : -1;
      inside = static_cast<char>(inside == 0);
    }
  };
  walk_faces(faces_, cross, [&](int face) {
    num_around[at(face)] = num_inside;
    is_in_first[at(face)] = is_inside[0];
  });
  for (std::size_t face = 0; face < num_around.size(); ++face) {
    const int n = num_around[face];
    const bool is_only_first = n == 1 && is_in_first[face] != 0;
    is_in_result_.push_back(static_cast<char>(operation == SetOperation::Union          ? n > 0
                                              : operation == SetOperation::Intersection ? n == operands_.count
                                                                                        : is_only_first));
  }
}

// Of the boundary those between inside and outside, of segments inside those with the result on both sides.
std::optional<int> Arrangement::source_kept(int segment) const {
  const auto& [left, right] = faces_.beside(segment);
  const bool parts = is_in_result_[at(left)] != is_in_result_[at(right)];
  if (!parts && is_in_result_[at(left)] == 0) return std::nullopt;
  const std::vector<int> all = sources(segment);
  const auto found =
      std::find_if(all.begin(), all.end(), [&](int source) { return (operands_.is_border[at(source)] != 0) == parts; });
  if (found == all.end()) return std::nullopt;
  return *found;
}

void Arrangement::find_groups() {
  DisjointSets groups(at(faces_.count()));
  for (int s = 0; s < faces_.num_segments(); ++s)
    if (!sources_kept_[at(s)]) groups.unite(faces_.beside(s)[0], faces_.beside(s)[1]);
  groups_.reserve(at(faces_.count()));
  for (int face = 0; face < faces_.count(); ++face) groups_.push_back(groups.find(face));
}

void Arrangement::give_region(int face, int region) {
  const auto [found, is_new] = regions_.emplace(groups_[at(face)], region);
  if (is_new || found->second == region) return;
  const LabelNames& names = operands_.all.region_names;
  throw GeometryError("nothing parts the regions '" + label_name(names, found->second) + "' and '" +
                      label_name(names, region) +
                      "' from each other in the result: where shapes meet or overlap "
                      "there is no side between them");
}

// A seed stands for all faces that no segment of its operand parts from it; of several operands' the first counts.
void Arrangement::find_regions() {
  std::vector<char> has_region(at(faces_.count()), 0);
  const std::vector<RegionSeed>& seeds = operands_.all.regions;
  for (std::size_t first = 0, last = 0; first < seeds.size(); first = last) {
    const int owner = operands_.region_owners[first];
    DisjointSets parts(has_region.size());
    for (int s = 0; s < faces_.num_segments(); ++s)
      if (!is_of(owner, s)) parts.unite(faces_.beside(s)[0], faces_.beside(s)[1]);
    std::map<int, int> region_of_part;
    for (; last < seeds.size() && operands_.region_owners[last] == owner; ++last)
      region_of_part.emplace(parts.find(faces_.at(seeds[last].point)), seeds[last].region);
    for (int face = 0; face < faces_.count(); ++face) {
      const auto found = region_of_part.find(parts.find(face));
      if (found == region_of_part.end() || is_in_result_[at(face)] == 0) continue;
      if (std::exchange(has_region[at(face)], char{1}) == 0) give_region(face, found->second);
    }
  }
}

// A piece of a straight segment may run against the one whose labels it gets.
Segment Arrangement::labelled(int segment, int source) const {
  Segment piece = subdivision_.segment(segment);
  const Segment& whole = operands_.all.segments[at(source)];
  piece.label = whole.label;
  piece.label_right = whole.label_right;
  const std::vector<int> all = sources(segment);
  piece.required = std::any_of(all.begin(), all.end(), [&](int other) {
    return operands_.is_border[at(other)] == operands_.is_border[at(source)] &&
           operands_.all.segments[at(other)].required;
  });
  const auto direction = [](const std::vector<Point>& points, const Segment& s) {
    return points[at(s.b)] - points[at(s.a)];
  };
  const bool turned = dot(direction(subdivision_.domain.points, piece), direction(operands_.all.points, whole)) < 0.0 &&
                      piece.is_straight();
  if (turned && piece.label_right) std::swap(piece.label, *piece.label_right);
  return piece;
}

std::vector<FacePoint> Arrangement::points_in_groups() const {
  const std::vector<FacePoint> points = faces_.points_inside();
  std::vector<FacePoint> best(points.size());
  for (int face = 0; face < faces_.count(); ++face) {
    FacePoint& candidate = best[at(groups_[at(face)])];
    if (points[at(face)].doubled_area > candidate.doubled_area) candidate = points[at(face)];
  }
  return best;
}

// One seed in each group of faces that the result encloses.
void Arrangement::add_holes(const std::vector<FacePoint>& points, Domain& domain) const {
  for (int face = 1; face < faces_.count(); ++face)
    if (groups_[at(face)] == face && is_in_result_[at(face)] == 0) domain.holes.push_back(points[at(face)].place);
}

// Given seeds stay where they are good.
void Arrangement::add_regions(const std::vector<FacePoint>& points, Domain& domain) const {
  std::map<int, int> missing = regions_;
  for (const RegionSeed& seed : operands_.all.regions) {
    const auto found = missing.find(groups_[at(faces_.at(seed.point))]);
    if (found == missing.end() || found->second != seed.region) continue;
    domain.regions.push_back(seed);
    missing.erase(found);
  }
  for (const auto& [group, region] : missing) domain.regions.push_back({points[at(group)].place, region});
}

/// Leaves out the points that nothing needs, and the curves.
Domain compacted(const Domain& domain, std::vector<char> is_needed) {
  Domain result = domain;
  result.points.clear();
  result.curves.clear();
  result.required_points.clear();
  for (const Segment& s : domain.segments) is_needed[at(s.a)] = is_needed[at(s.b)] = 1;
  std::vector<int> number(domain.points.size());
  for (std::size_t v = 0; v < domain.points.size(); ++v) {
    if (is_needed[v] == 0) continue;
    number[v] = static_cast<int>(result.points.size());
    result.points.push_back(domain.points[v]);
  }
  for (Segment& s : result.segments) {
    s = piece_of(s, number[at(s.a)], number[at(s.b)]);
    if (s.is_straight()) continue;
    result.curves.push_back(domain.curves[at(s.curve)]);
    s.curve = static_cast<int>(result.curves.size()) - 1;
  }
  for (const int v : domain.required_points)
    if (is_needed[at(v)] != 0) result.required_points.push_back(number[at(v)]);
  return result;
}

Result Arrangement::result() const {
  Domain domain = subdivision_.domain;
  std::vector<char> is_border;
  domain.segments.clear();
  domain.holes.clear();
  domain.inside = Inside::HoleSeeds;
  for (int s = 0; s < faces_.num_segments(); ++s) {
    if (!sources_kept_[at(s)]) continue;
    const auto& [left, right] = faces_.beside(s);
    domain.segments.push_back(labelled(s, *sources_kept_[at(s)]));
    is_border.push_back(static_cast<char>(is_in_result_[at(left)] != is_in_result_[at(right)]));
  }
  const std::vector<FacePoint> points = points_in_groups();
  add_holes(points, domain);
  add_regions(points, domain);
  std::vector<char> is_alone(domain.points.size(), 1);
  for (const Segment& s : subdivision_.domain.segments) is_alone[at(s.a)] = is_alone[at(s.b)] = 0;
  for (std::size_t v = 0; v < is_alone.size(); ++v)
    if (is_alone[v] != 0) is_alone[v] = is_in_result_[at(faces_.at(domain.points[v]))];
  return {compacted(domain, std::move(is_alone)), std::move(is_border)};
}

/// The curved ones of some segments of the operands; if none of them is, all that are.
std::vector<char> curved(const Operands& operands, const std::vector<int>& segments) {
  std::vector<char> all(operands.all.segments.size());
  std::vector<char> chosen(all.size(), 0);
  for (std::size_t s = 0; s < all.size(); ++s) all[s] = static_cast<char>(!operands.all.segments[s].is_straight());
  for (const int s : segments) chosen[at(s)] = all[at(s)];
  return std::find(chosen.begin(), chosen.end(), char{1}) == chosen.end() ? all : chosen;
}

/// Whether the curves end where their segments do, and all seeds of holes, which stand in the middle between chords,
/// are outside as the curves have it, those of regions inside.
bool is_fit(const Result& result) {
  if (result.domain.curves.empty()) return true;
  for (const Segment& s : result.domain.segments)
    if (!s.is_straight() && !ends_meet(result.domain, s)) return false;
  if (find_outline(result.domain).conflict) return false;
  const Faces faces(result.domain);
  std::vector<char> inside(at(faces.count()), 0);
  bool is_in = false;
  walk_faces(
      faces, [&](int s) { is_in = is_in != (result.is_border[at(s)] != 0); },
      [&](int face) { inside[at(face)] = static_cast<char>(is_in); });
  const auto is_inside = [&](const Point& p) { return inside[at(faces.at(p))] != 0; };
  return std::ranges::none_of(result.domain.holes, is_inside) &&
         std::ranges::all_of(result.domain.regions, is_inside, &RegionSeed::point);
}

}  // namespace

Domain combine(SetOperation operation, std::span<const Domain> domains) {
  Operands operands = gather(domains);
  std::vector<std::string> notes;
  for (const Domain& domain : domains) notes.insert(notes.end(), domain.notes.begin(), domain.notes.end());
  const auto put_chords = [&](const std::vector<int>& segments, const std::string& why) {
    const std::vector<char> replaced = curved(operands, segments);
    const auto count = std::ranges::count(replaced, char{1});
    operands = with_chords(operands, replaced);
    notes.push_back("put chords, off by 1e-4 of it at most, in place of " + std::to_string(count) +
                    (count == 1 ? " curve" : " curves") + why);
  };
  while (!operands.all.segments.empty()) {
    DomainRepair subdivision = subdivide_without_seeds(operands.all);
    if (const auto conflict = find_outline(subdivision.domain).conflict) {
      put_chords({subdivision.source_segment(conflict->first), subdivision.source_segment(conflict->second)},
                 " that cannot be told from others near " + rounded_text(conflict->place));
      continue;
    }
    Result result = Arrangement(operation, operands, std::move(subdivision)).result();
    if (is_fit(result)) {
      result.domain.notes = std::move(notes);
      return std::move(result.domain);
    }
    put_chords({}, ", of which some are too near to each other");
  }
  return {};
}

}  // namespace parmesan
