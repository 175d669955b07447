#include "adapt/domain_builder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "mesher/geometry/even_odd.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// Points along a path, n on each of its curves.
Ring ring_along(const Path& path, int n) {
  Ring ring;
  for (const PathPiece& piece : path) {
    ring.push_back(piece.begin);
    if (piece.curve) std::ranges::copy(piece.curve->points_between(0.0, 1.0, n), std::back_inserter(ring));
  }
  return ring;
}

double distance_to(const Ring& ring, const Point& p) {
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < ring.size(); ++i)
    nearest = std::min(nearest, norm(nearest_on_segment(ring[i], ring[(i + 1) % ring.size()], p) - p));
  return nearest;
}

// Polygons with few points have inner points well off the path, but perhaps beyond it: the best of several.
Point interior_point(const Path& path) {
  constexpr int fine = 512;
  const Ring outline = ring_along(path, fine);
  Point best = parmesan::interior_point(outline);
  double farthest = 0.0;
  for (int n = 4; n <= fine; n *= 2) {
    const Point p = parmesan::interior_point(ring_along(path, n));
    if (!is_inside(p, outline) || distance_to(outline, p) <= farthest) continue;
    best = p;
    farthest = distance_to(outline, p);
  }
  return best;
}

}  // namespace

DomainBuilder::DomainBuilder(Domain domain) : domain_(std::move(domain)) {
  for (const Segment& segment : domain_.segments)
    last_label_ = std::max({last_label_, segment.label, segment.label_right.value_or(segment.label)});
  for (const auto& [number, name] : domain_.label_names) {
    last_label_ = std::max(last_label_, number);
    label_of_name_.emplace(name, number);
  }
}

int DomainBuilder::label(const std::string& name) {
  const auto [entry, added] = label_of_name_.emplace(name, last_label_ + 1);
  if (added) domain_.label_names[++last_label_] = name;
  return entry->second;
}

void DomainBuilder::add_ring(const Ring& ring, const std::vector<std::string>& sides) {
  const int first = static_cast<int>(domain_.points.size());
  const int n = static_cast<int>(ring.size());
  domain_.points.insert(domain_.points.end(), ring.begin(), ring.end());
  for (int i = 0; i < n; ++i) {
    const std::string& name = sides.size() == 1 ? sides.front() : sides[at(i)];
    domain_.segments.push_back({first + i, first + (i + 1) % n, label(name)});
  }
}

void DomainBuilder::add_hole(const Ring& ring, const std::string& side) {
  add_ring(ring, {side});
  domain_.holes.push_back(interior_point(ring));
}

int DomainBuilder::point_at(const Point& p) {
  for (; num_indexed_ < std::ssize(domain_.points); ++num_indexed_) {
    const Point& known = domain_.points[at(num_indexed_)];
    point_of_place_.try_emplace({known.x, known.y}, num_indexed_);
  }
  const auto [found, is_new] = point_of_place_.try_emplace({p.x, p.y}, num_indexed_);
  if (is_new) {
    domain_.points.push_back(p);
    ++num_indexed_;
  }
  return found->second;
}

int DomainBuilder::curve(const Curve& curve) {
  domain_.curves.push_back(curve);
  return static_cast<int>(domain_.curves.size()) - 1;
}

// Where a curve and a line meet, the line's end is the one that the user gave.
void DomainBuilder::add_path(const Path& path) {
  const int first = static_cast<int>(domain_.points.size());
  const int n = static_cast<int>(path.size());
  for (int i = 0; i < n; ++i) {
    const PathPiece& piece = path[at(i)];
    const PathPiece& before = path[at((i + n - 1) % n)];
    domain_.points.push_back(before.curve ? piece.begin : before.end);
    const int along = piece.curve ? curve(*piece.curve) : -1;
    domain_.segments.push_back({first + i, first + (i + 1) % n, label(piece.label), {}, false, along});
  }
}

void DomainBuilder::add_hole(const Path& path) {
  add_path(path);
  domain_.holes.push_back(interior_point(path));
}

void DomainBuilder::add_curve(const Curve& along, const std::string& name, const std::optional<std::string>& right) {
  constexpr double rounding = 1e-12;
  const Point begin = along.at(0.0), end = along.at(1.0);
  const bool is_closed = norm(end - begin) <= rounding * along.extent();
  add_segment(begin, is_closed ? begin : end, name, right);
  domain_.segments.back().curve = curve(along);
}

void DomainBuilder::add_point(const Point& p, bool is_required) {
  if (is_required) domain_.required_points.push_back(static_cast<int>(domain_.points.size()));
  domain_.points.push_back(p);
}

void DomainBuilder::add_segment(const Point& a, const Point& b, const std::string& name,
                                const std::optional<std::string>& right, bool is_required) {
  const int first = point_at(a);
  domain_.segments.push_back({first, point_at(b), label(name)});
  if (right) domain_.segments.back().label_right = label(*right);
  domain_.segments.back().required = is_required;
}

int DomainBuilder::region(const std::string& name) {
  const auto found =
      std::ranges::find_if(domain_.region_names, [&name](const auto& entry) { return entry.second == name; });
  if (found != domain_.region_names.end()) return found->first;
  const int next = domain_.region_names.empty() ? 1 : std::max(1, domain_.region_names.rbegin()->first + 1);
  domain_.region_names[next] = name;
  return next;
}

Domain DomainBuilder::renumbered(Domain domain) {
  for (Segment& s : domain.segments) {
    s.label = label(label_name(domain.label_names, s.label));
    if (s.label_right) s.label_right = label(label_name(domain.label_names, *s.label_right));
  }
  for (RegionSeed& seed : domain.regions) seed.region = region(label_name(domain.region_names, seed.region));
  domain.label_names.clear();
  domain.region_names = domain_.region_names;
  return domain;
}

void DomainBuilder::replace(Domain domain) {
  domain.label_names = std::move(domain_.label_names);
  domain.region_names = std::move(domain_.region_names);
  domain_ = std::move(domain);
  point_of_place_.clear();
  num_indexed_ = 0;
}

void DomainBuilder::add_region(const std::string& name, const Point& seed) {
  int region = 1;
  for (const RegionSeed& other : domain_.regions) region = std::max(region, other.region + 1);
  domain_.regions.push_back({seed, region});
  domain_.region_names[region] = name;
}

std::vector<int> DomainBuilder::labels_in_use() const {
  std::set<int> labels;
  const auto point = [this](int i) { return domain_.points[at(i)]; };
  for (const Segment& segment : domain_.segments)
    if (!segment.is_straight() || point(segment.a) != point(segment.b)) labels.insert(segment.label);
  for (const int label : crack_labels()) labels.insert(label);
  return {labels.begin(), labels.end()};
}

std::vector<int> DomainBuilder::crack_labels() const {
  std::set<int> labels;
  for (const Segment& segment : domain_.segments)
    if (segment.label_right) labels.insert({segment.label, *segment.label_right});
  return {labels.begin(), labels.end()};
}

}  // namespace parmesan
