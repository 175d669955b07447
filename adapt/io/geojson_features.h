#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesher/geometry/point.h"

namespace parmesan {

/// The largest GeoJSON text that is read, and its deepest nesting.
inline constexpr std::size_t kMaxGeoJsonBytes = std::size_t{256} << 20;
inline constexpr int kMaxGeoJsonDepth = 64;

/// A closed chain of points, the first one not repeated.
using GeoRing = std::vector<Point>;

/// The rings of one polygon, its outline first.
using GeoPolygon = std::vector<GeoRing>;

/// The polygons of one feature and its name, empty when it has none.
struct GeoFeature {
  std::string name;
  std::vector<GeoPolygon> polygons;
};

/// What a text has.
struct GeoFeatures {
  std::vector<GeoFeature> features;  // those with polygons
  std::string left_out;              // points and lines: "1 LineString, 2 Points"
};

/// All features with polygons in a GeoJSON text. Errors: as parse_geojson.
GeoFeatures parse_geojson_features(const std::string& text, const std::string& name);

}  // namespace parmesan
