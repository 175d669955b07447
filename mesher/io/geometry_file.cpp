#include "mesher/io/geometry_file.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mesher/errors.h"
#include "mesher/geometry/domain_of_mesh.h"
#include "mesher/index.h"
#include "mesher/io/airfoil_file.h"
#include "mesher/io/boundary_edges.h"
#include "mesher/io/mesh_file.h"
#include "mesher/io/text.h"
#include "mesher/io/triangle_files.h"

namespace parmesan {
namespace {

Domain domain_of_edges(Mesh mesh) {
  Domain domain;
  domain.inside = Inside::EvenOdd;
  domain.first_number = mesh.first_number;
  domain.segments.reserve(mesh.edges.size());
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    domain.segments.push_back({mesh.edges[i][0], mesh.edges[i][1], mesh.labels[i]});
  }
  for (const int e : mesh.required.edges) domain.segments[at(e)].required = true;
  domain.required_points = std::move(mesh.required.vertices);
  domain.points = std::move(mesh.points);
  domain.label_names = std::move(mesh.label_names);
  return domain;
}

}  // namespace

bool is_domain_file_name(const std::string& path) {
  const std::string suffix = file_suffix(path);
  return suffix == ".poly" || suffix == ".dat";
}

bool is_geometry_file_name(const std::string& path) {
  constexpr std::array mesh_suffixes{".mesh", ".meshb", ".msh", ".node", ".ele"};
  return is_domain_file_name(path) ||
         std::find(mesh_suffixes.begin(), mesh_suffixes.end(), file_suffix(path)) != mesh_suffixes.end();
}

Domain read_geometry(const std::string& path) {
  if (!is_geometry_file_name(path)) {
    throw FileError(path, 0, "no geometry is read from this suffix; known are .poly .dat .mesh .meshb .msh .node .ele");
  }
  const std::string suffix = file_suffix(path);
  if (suffix == ".poly") return read_poly(path);
  if (suffix == ".dat") return read_airfoil(path);
  return geometry_of(read_mesh_file(path));
}

Domain geometry_of(Mesh mesh) {
  if (mesh.triangles.empty()) return domain_of_edges(std::move(mesh));
  cover_boundary(mesh);
  return domain_of(mesh);
}

}  // namespace parmesan
