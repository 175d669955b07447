#include "adapt/io/any_geometry.h"

#include <string>
#include <utility>

#include "adapt/io/geojson.h"
#include "mesher/errors.h"
#include "mesher/geometry/domain_of_mesh.h"
#include "mesher/geometry/predicates.h"
#include "mesher/index.h"
#include "mesher/io/boundary_edges.h"
#include "mesher/io/geometry_file.h"
#include "mesher/io/mesh_file.h"
#include "mesher/io/msh.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

bool is_geojson_file_name(const std::string& path) {
  const std::string suffix = file_suffix(path);
  return suffix == ".geojson" || suffix == ".json";
}

// Its sides would enclose nothing, or something else.
void refuse_clockwise_triangles(const Mesh& mesh) {
  for (int i = 0; i < mesh.num_triangles(); ++i) {
    const auto& [a, b, c] = mesh.triangles[at(i)];
    const auto point = [&mesh](int v) { return mesh.points[at(v)]; };
    if (orient2d(point(a), point(b), point(c)) < 0.0)
      throw GeometryError("triangle " + number_text(mesh, i) + " is clockwise, others are not", {i});
  }
}

GeometryInput read_other_geometry(const std::string& path) {
  if (is_domain_file_name(path)) return {read_geometry(path), std::nullopt};
  MeshData data = file_suffix(path) == ".msh" ? read_msh(path) : MeshData{.mesh = read_mesh_file(path), .fields = {}};
  Mesh& mesh = data.mesh;
  if (mesh.triangles.empty()) return {geometry_of(std::move(mesh)), std::nullopt};
  refuse_clockwise_triangles(mesh);
  cover_boundary(mesh);
  Domain domain = domain_of(mesh);
  domain.notes.insert(domain.notes.begin(), data.mesh_notes.begin(), data.mesh_notes.end());
  return {std::move(domain), std::move(mesh)};
}

}  // namespace

GeometryInput read_geometry_input(const std::string& path, Crossings crossings, double merge_tolerance) {
  if (is_geojson_file_name(path)) return {read_geojson(path, crossings, merge_tolerance), std::nullopt};
  if (!is_geometry_file_name(path))
    throw FileError(
        path, 0,
        "no geometry is read from this suffix; known are .poly .dat .geojson .json .mesh .meshb .msh .node .ele");
  GeometryInput input = read_other_geometry(path);
  input.domain.merge_tolerance = merge_tolerance;
  return input;
}

bool is_any_domain_file_name(const std::string& path) {
  return is_geojson_file_name(path) || is_domain_file_name(path);
}

}  // namespace parmesan
