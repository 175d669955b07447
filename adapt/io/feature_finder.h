#pragma once

#include <compare>
#include <vector>

#include "adapt/io/geojson_features.h"
#include "mesher/geometry/box_tree.h"

namespace parmesan {

/// Finds the smallest feature around a point, of several the first. The features are referred to, not copied.
/// Cost: O(n log n) to build, O(log n) expected for a search where few overlap.
class FeatureFinder {
 public:
  explicit FeatureFinder(const std::vector<GeoFeature>& features);

  /// The number of its region, 1, 2, ...; 0 outside of all.
  int region_at(const Point& p) const;

  /// Errors: GeometryError where a polygon has a hole around the point, but not its outline.
  void refuse_stray_holes_at(const Point& p) const;

 private:
  /// A feature, by its number, and how large it is.
  struct SizedFeature {
    double area = 0.0;
    int number = 0;
    auto operator<=>(const SizedFeature&) const = default;
  };
  static std::vector<SizedFeature> in_local_order(const std::vector<GeoFeature>& features);

  const std::vector<GeoFeature>& features_;
  std::vector<SizedFeature> sized_;
  BoxTree boxes_;
};

}  // namespace parmesan
