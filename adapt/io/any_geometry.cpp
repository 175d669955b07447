#include "adapt/io/any_geometry.h"

#include <utility>

#include "adapt/io/geojson.h"
#include "mesher/errors.h"
#include "mesher/io/boundary_edges.h"
#include "mesher/io/geometry_file.h"
#include "mesher/io/mesh_file.h"
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

GeometryInput read_geometry_input(const std::string& path) {
  const bool may_be_mesh = is_geometry_file_name(path) && !is_domain_file_name(path);
  if (!may_be_mesh) return {read_any_geometry(path), std::nullopt};
  Mesh mesh = read_mesh_file(path);
  if (mesh.triangles.empty()) return {geometry_of(std::move(mesh)), std::nullopt};
  Domain domain = domain_of(mesh);
  cover_boundary(mesh);
  return {std::move(domain), std::move(mesh)};
}

bool is_any_domain_file_name(const std::string& path) {
  return is_geojson_file_name(path) || is_domain_file_name(path);
}

}  // namespace parmesan
