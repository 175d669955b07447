#include "adapt/domain_builder.h"

#include <algorithm>
#include <set>
#include <utility>

namespace parmesan {

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
    const std::string& name = sides.size() == 1 ? sides.front() : sides[static_cast<std::size_t>(i)];
    domain_.segments.push_back({first + i, first + (i + 1) % n, label(name)});
  }
}

void DomainBuilder::add_hole(const Ring& ring, const std::string& side) {
  add_ring(ring, {side});
  domain_.holes.push_back(interior_point(ring));
}

void DomainBuilder::add_point(const Point& p, bool is_required) {
  if (is_required) domain_.required_points.push_back(static_cast<int>(domain_.points.size()));
  domain_.points.push_back(p);
}

void DomainBuilder::add_segment(const Point& a, const Point& b, const std::string& name,
                                const std::optional<std::string>& right, bool is_required) {
  const int first = static_cast<int>(domain_.points.size());
  domain_.points.insert(domain_.points.end(), {a, b});
  domain_.segments.push_back({first, first + 1, label(name)});
  if (right) domain_.segments.back().label_right = label(*right);
  domain_.segments.back().required = is_required;
}

void DomainBuilder::add_region(const std::string& name, const Point& seed) {
  int region = 1;
  for (const RegionSeed& other : domain_.regions) region = std::max(region, other.region + 1);
  domain_.regions.push_back({seed, region});
  domain_.region_names[region] = name;
}

std::vector<int> DomainBuilder::labels_in_use() const {
  std::set<int> labels;
  for (const Segment& segment : domain_.segments) labels.insert(segment.label);
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
