#include <cassert>
#include <utility>
#include <vector>

#include "mesher/io/gmf.h"
#include "mesher/io/medit.h"
#include "mesher/io/output_file.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

void read_vertices(GmfReader& in, Mesh& mesh) {
  mesh.points.resize(in.start(GmfKeyword::Vertices, "the number of vertices", 3));
  for (Point& point : mesh.points) {
    point.x = in.real("the x coordinate");
    point.y = in.real("the y coordinate");
    if (in.dimension() == 3 && in.real("the z coordinate") != 0.0)
      in.fail("z is not 0: the mesh must lie in the plane");
    in.integer("the vertex reference");
  }
  in.require_end();
}

/// Entities of N vertices with a reference.
template <std::size_t N>
void read_entities(GmfReader& in, GmfKeyword keyword, int num_vertices, std::vector<std::array<int, N>>& entities,
                   std::vector<int>& references) {
  if (!in.has(keyword)) return;
  const std::size_t count = in.start(keyword, "the number of edges or triangles", N + 1);
  entities.resize(count);
  references.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (int& vertex : entities[i]) vertex = in.index("the vertex of an edge or a triangle", num_vertices);
    references[i] = in.integer("the reference of an edge or a triangle");
  }
  in.require_end();
}

std::vector<int> read_numbers(GmfReader& in, GmfKeyword keyword, int size) {
  if (!in.has(keyword)) return {};
  std::vector<int> numbers(in.start(keyword, "the number of required entities", 1));
  for (int& number : numbers) number = in.index("a required entity", size);
  in.require_end();
  return ascending(std::move(numbers));
}

void write_numbers(GmfWriter& out, GmfKeyword keyword, const std::vector<int>& numbers) {
  if (numbers.empty()) return;
  out.start(keyword, numbers.size(), sizeof(std::int32_t));
  for (const int number : numbers) out.integer(number + 1);
}

void refuse_other_elements(GmfReader& in) {
  using enum GmfKeyword;
  for (const GmfKeyword keyword : {Quadrilaterals, Tetrahedra, Prisms, Hexahedra, Pyramids}) {
    if (in.has(keyword) && in.start(keyword, "the number of elements", 1) > 0) {
      in.fail("has elements that are not triangles");
    }
  }
}

template <std::size_t N>
void write_entities(GmfWriter& out, GmfKeyword keyword, const std::vector<std::array<int, N>>& entities,
                    const std::vector<int>& references) {
  if (entities.empty()) return;
  out.start(keyword, entities.size(), (N + 1) * sizeof(std::int32_t));
  for (std::size_t i = 0; i < entities.size(); ++i) {
    for (const int vertex : entities[i]) out.integer(vertex + 1);
    out.integer(references[i]);
  }
}

}  // namespace

Mesh parse_meshb(std::string_view bytes, const std::string& name) {
  GmfReader in(bytes, name);
  refuse_other_elements(in);
  if (!in.has(GmfKeyword::Vertices)) in.fail("the keyword Vertices is missing");
  Mesh mesh;
  mesh.first_number = 1;
  read_vertices(in, mesh);
  read_entities(in, GmfKeyword::Edges, mesh.num_vertices(), mesh.edges, mesh.labels);
  read_entities(in, GmfKeyword::Triangles, mesh.num_vertices(), mesh.triangles, mesh.regions);
  mesh.required.vertices = read_numbers(in, GmfKeyword::RequiredVertices, mesh.num_vertices());
  mesh.required.edges = read_numbers(in, GmfKeyword::RequiredEdges, mesh.num_edges());
  mesh.required.triangles = read_numbers(in, GmfKeyword::RequiredTriangles, mesh.num_triangles());
  return mesh;
}

Mesh read_meshb(const std::string& path) { return parse_meshb(read_file(path), path); }

void write_meshb(const std::string& path, const Mesh& mesh) {
  assert(mesh.labels.size() == mesh.edges.size() && mesh.regions.size() == mesh.triangles.size());
  OutputFile file(path);
  const RequiredParts& required = mesh.required;
  const std::size_t num_required = required.vertices.size() + required.edges.size() + required.triangles.size();
  const std::size_t bytes =
      20 * mesh.points.size() + 12 * mesh.edges.size() + 16 * mesh.triangles.size() + 4 * num_required + 200;
  GmfWriter out(file, bytes);
  out.start(GmfKeyword::Vertices, mesh.points.size(), 2 * sizeof(double) + sizeof(std::int32_t));
  for (const Point& point : mesh.points) {
    out.real(point.x);
    out.real(point.y);
    out.integer(0);
  }
  write_entities(out, GmfKeyword::Edges, mesh.edges, mesh.labels);
  write_entities(out, GmfKeyword::Triangles, mesh.triangles, mesh.regions);
  write_numbers(out, GmfKeyword::RequiredVertices, required.vertices);
  write_numbers(out, GmfKeyword::RequiredEdges, required.edges);
  write_numbers(out, GmfKeyword::RequiredTriangles, required.triangles);
  out.finish();
  file.commit();
}

}  // namespace parmesan
