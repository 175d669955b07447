#include "adapt/io/feature_finder.h"

#include <cmath>
#include <optional>
#include <string>

#include "mesher/errors.h"
#include "mesher/geometry/even_odd.h"
#include "mesher/geometry/hilbert.h"
#include "mesher/index.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

/// Whether an odd number of the feature's rings lie around a point that is on none of them.
bool encloses(const GeoFeature& feature, const Point& p) {
  bool encloses = false;
  for (const GeoPolygon& polygon : feature.polygons) {
    for (const GeoRing& ring : polygon)
      if (is_inside(p, ring)) encloses = !encloses;
  }
  return encloses;
}

/// Twice the area of all rings, holes not taken off.
double doubled_area(const GeoFeature& feature) {
  double sum = 0.0;
  for (const GeoPolygon& polygon : feature.polygons) {
    for (const GeoRing& ring : polygon) {
      double of_ring = 0.0;
      for (std::size_t i = 1; i + 1 < ring.size(); ++i) of_ring += doubled_area(ring[0], ring[i], ring[i + 1]);
      sum += std::abs(of_ring);
    }
  }
  return sum;
}

BoxTree::Box box_around(const GeoFeature& feature) {
  BoxTree::Box box;
  for (const GeoPolygon& polygon : feature.polygons)
    for (const GeoRing& ring : polygon)
      for (const Point& p : ring) box.add(p);
  return box;
}

}  // namespace

// In the order of a Hilbert curve.
std::vector<FeatureFinder::SizedFeature> FeatureFinder::in_local_order(const std::vector<GeoFeature>& features) {
  std::vector<Point> centres;
  centres.reserve(features.size());
  for (const GeoFeature& feature : features) {
    const BoxTree::Box box = box_around(feature);
    centres.push_back(midpoint(box.low, box.high));
  }
  std::vector<SizedFeature> sized;
  sized.reserve(features.size());
  for (const int i : hilbert_order(centres)) sized.push_back({doubled_area(features[at(i)]), i});
  return sized;
}

FeatureFinder::FeatureFinder(const std::vector<GeoFeature>& features)
    : features_(features),
      sized_(in_local_order(features)),
      boxes_(sized_.size(), [&](std::size_t i) { return box_around(features[at(sized_[i].number)]); }) {}

int FeatureFinder::region_at(const Point& p) const {
  std::optional<SizedFeature> smallest;
  const auto may_hold = [&p](const BoxTree::Box& box) { return box.squared_distance(p) == 0.0; };
  boxes_.for_each_in(may_hold, [&](std::size_t i) {
    const SizedFeature& feature = sized_[i];
    if ((!smallest || feature < *smallest) && encloses(features_[at(feature.number)], p)) smallest = feature;
  });
  return smallest ? smallest->number + 1 : 0;
}

void FeatureFinder::refuse_stray_holes_at(const Point& p) const {
  const auto may_hold = [&p](const BoxTree::Box& box) { return box.squared_distance(p) == 0.0; };
  boxes_.for_each_in(may_hold, [&](std::size_t i) {
    const GeoFeature& feature = features_[at(sized_[i].number)];
    for (const GeoPolygon& polygon : feature.polygons) {
      if (polygon.empty() || is_inside(p, polygon.front())) continue;
      for (std::size_t ring = 1; ring < polygon.size(); ++ring) {
        if (!is_inside(p, polygon[ring])) continue;
        const std::string owner = feature.name.empty() ? "" : " of '" + feature.name.substr(0, 60) + "'";
        throw GeometryError("the hole that begins at " + text(polygon[ring].front()) + ", ring " +
                            std::to_string(ring) + " of a polygon" + owner +
                            ", does not lie inside of the polygon's outline, its first ring; an area of its own is a "
                            "polygon of its own");
      }
    }
  });
}

}  // namespace parmesan
