#include "adapt/io/any_geometry.h"

#include "adapt/io/geojson.h"
#include "mesher/errors.h"
#include "mesher/io/geometry_file.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

bool is_geojson_file_name(const std::string& path) {
  const std::string suffix = file_suffix(path);
  return suffix == ".geojson" || suffix == ".json";
}

}  // namespace

Domain read_any_geometry(const std::string& path) {
  if (is_geojson_file_name(path)) return read_geojson(path);
  if (is_geometry_file_name(path)) return read_geometry(path);
  throw FileError(
      path, 0,
      "no geometry is read from this suffix; known are .poly .dat .geojson .json .mesh .meshb .msh .node .ele");
}

bool is_any_domain_file_name(const std::string& path) {
  return is_geojson_file_name(path) || is_domain_file_name(path);
}

}  // namespace parmesan
