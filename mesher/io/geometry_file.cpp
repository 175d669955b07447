#include "mesher/io/geometry_file.h"

#include <utility>

#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "mesher/io/text.h"
#include "mesher/io/triangle_files.h"

namespace parmesan {
namespace {

Domain domain_of_edges(Mesh mesh) {
  Domain domain;
  domain.inside = Inside::EvenOdd;
  domain.segments.reserve(mesh.edges.size());
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    domain.segments.push_back({mesh.edges[i][0], mesh.edges[i][1], mesh.labels[i]});
  }
  domain.points = std::move(mesh.points);
  return domain;
}

}  // namespace

Domain read_geometry(const std::string& path) {
  const std::string suffix = file_suffix(path);
  if (suffix == ".poly") return read_poly(path);
  if (suffix == ".mesh") {
    Mesh mesh = read_medit(path);
    return mesh.triangles.empty() ? domain_of_edges(std::move(mesh)) : domain_of(mesh);
  }
  if (suffix == ".node" || suffix == ".ele") return domain_of(read_triangle_mesh(path));
  throw FileError(path, 0, "no geometry is read from this suffix; known are .poly .mesh .node .ele");
}

}  // namespace parmesan
