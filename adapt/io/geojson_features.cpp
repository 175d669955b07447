#include "adapt/io/geojson_features.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "adapt/json_text.h"
#include "mesher/errors.h"

namespace parmesan {
namespace {

using Json = nlohmann::json;

class GeoJsonReader {
 public:
  GeoJsonReader(const std::string& text, const std::string& name) : text_(text), name_(name) {}

  GeoFeatures read() {
    read_object(parse(), "", {});
    const std::string left_out = left_out_text();
    if (features_.empty())
      throw FileError(name_, 0, "has no polygons" + (left_out.empty() ? "" : ", only " + left_out));
    return {std::move(features_), left_out};
  }

 private:
  Json parse() const {
    if (text_.size() > kMaxGeoJsonBytes) {
      throw FileError(name_, 0, "is larger than " + std::to_string(kMaxGeoJsonBytes >> 20) + " MiB");
    }
    const auto limit_depth = [this](int depth, Json::parse_event_t, const Json&) {
      if (depth > kMaxGeoJsonDepth) throw FileError(name_, 0, "is nested too deep");
      return true;
    };
    try {
      Json parsed = Json::parse(text_, limit_depth);
      refuse_duplicate_keys();
      return parsed;
    } catch (const Json::parse_error& error) {
      throw FileError(name_, line_column(text_, error.byte > 0 ? error.byte - 1 : 0).line, "is not JSON");
    } catch (const Json::exception&) {
      throw FileError(name_, 0, "is not JSON: a number is beyond double precision");
    }
  }

  /// Of them the library would take the last one.
  void refuse_duplicate_keys() const {
    for (const DuplicateKey& key : find_duplicate_keys(text_, 1))
      throw FileError(name_, line_column(text_, key.offset).line, key.pointer + " is given twice");
  }

  [[noreturn]] void refuse(const std::string& pointer, const std::string& problem) const {
    const int line = line_column(text_, locate(text_, pointer).value).line;
    throw FileError(name_, line, (pointer.empty() ? "the document" : pointer) + " " + problem);
  }

  const Json& member(const Json& object, const char* key, const std::string& pointer) const {
    const auto found = object.find(key);
    if (found == object.end()) refuse(pointer, std::string("has no \"") + key + "\"");
    return *found;
  }

  const Json& array(const Json& value, const std::string& pointer) const {
    if (!value.is_array()) refuse(pointer, "must be an array");
    return value;
  }

  /// feature: the name of the feature that the object belongs to.
  void read_object(const Json& object, const std::string& pointer, const std::string& feature) {
    if (!object.is_object()) refuse(pointer, "must be an object");
    if (pointer.empty() && object.is_object() && !object.contains("type"))
      refuse(pointer, "has no \"type\", as GeoJSON has, nor the \"geometry\" of a case file");
    const Json& type = member(object, "type", pointer);
    if (type == "FeatureCollection") {
      read_list(member(object, "features", pointer), pointer + "/features", feature);
    } else if (type == "Feature") {
      read_feature(object, pointer);
    } else if (type == "GeometryCollection") {
      read_list(member(object, "geometries", pointer), pointer + "/geometries", feature);
    } else if (type == "Polygon") {
      features_of(feature).push_back(read_polygon(member(object, "coordinates", pointer), pointer + "/coordinates"));
    } else if (type == "MultiPolygon") {
      read_multi_polygon(member(object, "coordinates", pointer), pointer + "/coordinates", feature);
    } else if (!pointer.empty() && is_without_area(type)) {
      ++left_out_[type.get<std::string>()];
    } else {
      refuse(pointer + "/type", "must be Polygon, MultiPolygon, GeometryCollection, Feature or FeatureCollection");
    }
  }

  static bool is_without_area(const Json& type) {
    constexpr std::array types{"Point", "MultiPoint", "LineString", "MultiLineString"};
    return std::ranges::any_of(types, [&type](const char* one) { return type == one; });
  }

  std::string left_out_text() const {
    std::string list;
    for (const auto& [type, count] : left_out_)
      list += (list.empty() ? "" : ", ") + std::to_string(count) + " " + type + (count == 1 ? "" : "s");
    return list;
  }

  void read_list(const Json& list, const std::string& pointer, const std::string& feature) {
    std::size_t i = 0;
    for (const Json& element : array(list, pointer)) read_object(element, pointer + "/" + std::to_string(i++), feature);
  }

  void read_feature(const Json& object, const std::string& pointer) {
    const Json& geometry = member(object, "geometry", pointer);
    if (geometry.is_null()) return;
    begins_feature_ = true;
    std::string name;
    const auto properties = object.find("properties");
    if (properties != object.end() && properties->is_object()) {
      const auto found = properties->find("name");
      if (found != properties->end() && found->is_string()) name = found->get<std::string>();
    }
    read_object(geometry, pointer + "/geometry", name);
    begins_feature_ = true;
  }

  /// The polygons of the feature that is read, which is begun where that has not been done.
  std::vector<GeoPolygon>& features_of(const std::string& name) {
    if (begins_feature_ || features_.empty()) features_.push_back({name, {}});
    begins_feature_ = false;
    return features_.back().polygons;
  }

  void read_multi_polygon(const Json& list, const std::string& pointer, const std::string& feature) {
    std::size_t i = 0;
    for (const Json& polygon : array(list, pointer)) {
      features_of(feature).push_back(read_polygon(polygon, pointer + "/" + std::to_string(i++)));
    }
  }

  GeoPolygon read_polygon(const Json& rings, const std::string& pointer) const {
    GeoPolygon polygon;
    for (const Json& ring : array(rings, pointer)) {
      polygon.push_back(read_ring(ring, pointer + "/" + std::to_string(polygon.size())));
    }
    return polygon;
  }

  GeoRing read_ring(const Json& positions, const std::string& pointer) const {
    GeoRing ring;
    for (const Json& position : array(positions, pointer)) {
      const bool is_point =
          position.is_array() && position.size() >= 2 && position[0].is_number() && position[1].is_number();
      if (!is_point) refuse(pointer + "/" + std::to_string(ring.size()), "must be two numbers");
      ring.push_back({position[0].get<double>(), position[1].get<double>()});
    }
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
  }

  const std::string& text_;
  const std::string& name_;
  std::vector<GeoFeature> features_;
  bool begins_feature_ = false;
  std::map<std::string, int> left_out_;  // how many of each type
};

}  // namespace

GeoFeatures parse_geojson_features(const std::string& text, const std::string& name) {
  return GeoJsonReader(text, name).read();
}

}  // namespace parmesan
