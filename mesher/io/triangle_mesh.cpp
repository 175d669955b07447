#include <algorithm>
#include <cassert>
#include <filesystem>
#include <system_error>
#include <utility>

#include "mesher/io/output_file.h"
#include "mesher/io/text.h"
#include "mesher/io/triangle_files.h"
#include "mesher/io/triangle_rows.h"

namespace parmesan {
namespace {

using DirectedSide = std::array<int, 2>;

void read_ele(TextReader& in, const TriangleNodes& nodes, Mesh& mesh) {
  const int count = in.count("the number of triangles", 4);
  if (integer_on_line_or(in, "the number of nodes per triangle", 3) != 3) in.fail("triangles must have 3 nodes");
  const bool has_region = integer_on_line_or(in, "the number of attributes", 0) > 0;
  in.skip_line();
  mesh.triangles.resize(static_cast<std::size_t>(count));
  mesh.regions.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    start_row(in, nodes.base, i);
    const auto triangle = static_cast<std::size_t>(i);
    for (int& vertex : mesh.triangles[triangle]) vertex = index_on_line(in, "the vertex of a triangle", nodes);
    if (has_region) mesh.regions[triangle] = region_on_line(in);
    in.skip_line();
  }
  in.require_end("the triangles");
}

/// The sides of all triangles in their direction, sorted.
std::vector<DirectedSide> directed_sides(const Mesh& mesh) {
  std::vector<DirectedSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) sides.insert(sides.end(), {{a, b}, {b, c}, {c, a}});
  std::sort(sides.begin(), sides.end());
  return sides;
}

void read_edge(TextReader& in, const TriangleNodes& nodes, Mesh& mesh) {
  const std::vector<DirectedSide> sides = directed_sides(mesh);
  const auto is_side = [&sides](int a, int b) {
    return std::binary_search(sides.begin(), sides.end(), DirectedSide{a, b});
  };
  const int count = in.count("the number of edges", 3);
  in.skip_line();
  for (int i = 0; i < count; ++i) {
    start_row(in, nodes.base, i);
    DirectedSide edge{};
    for (int& vertex : edge) vertex = index_on_line(in, "the vertex of an edge", nodes);
    const int label = integer_on_line_or(in, "the marker of an edge", 0);
    in.skip_line();
    const bool has_left = is_side(edge[0], edge[1]);
    const bool has_right = is_side(edge[1], edge[0]);
    if (label == 0 && has_left == has_right) continue;
    if (has_right && !has_left) std::swap(edge[0], edge[1]);
    mesh.edges.push_back(edge);
    mesh.labels.push_back(label);
  }
  in.require_end("the edges");
}

void write_node(const std::string& path, const Mesh& mesh) {
  OutputFile out(path);
  out << mesh.points.size() << " 2 0 0\n";
  int row = 0;
  for (const Point& point : mesh.points) out << ++row << ' ' << point.x << ' ' << point.y << '\n';
  out.commit();
}

void write_ele(const std::string& path, const Mesh& mesh) {
  OutputFile out(path);
  out << mesh.triangles.size() << " 3 1\n";
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    out << i + 1;
    for (const int vertex : mesh.triangles[i]) out << ' ' << vertex + 1;
    out << ' ' << mesh.regions[i] << '\n';
  }
  out.commit();
}

void write_edge(const std::string& path, const Mesh& mesh) {
  OutputFile out(path);
  out << mesh.edges.size() << " 1\n";
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    out << i + 1 << ' ' << mesh.edges[i][0] + 1 << ' ' << mesh.edges[i][1] + 1 << ' ' << mesh.labels[i] << '\n';
  }
  out.commit();
}

}  // namespace

Mesh parse_triangle_mesh(std::string_view node_text, std::string_view ele_text, std::string_view edge_text,
                         const std::string& stem) {
  const std::string node_path = stem + ".node";
  TextReader node_in(node_text, node_path);
  TriangleNodes nodes = read_triangle_nodes(node_in);
  Mesh mesh;
  const std::string ele_path = stem + ".ele";
  TextReader ele_in(ele_text, ele_path);
  read_ele(ele_in, nodes, mesh);
  if (!edge_text.empty()) {
    const std::string edge_path = stem + ".edge";
    TextReader edge_in(edge_text, edge_path);
    read_edge(edge_in, nodes, mesh);
  }
  mesh.points = std::move(nodes.points);
  mesh.first_number = nodes.base;
  return mesh;
}

Mesh read_triangle_mesh(const std::string& path) {
  const std::string edge_path = with_suffix(path, ".edge");
  std::error_code ignored;
  const bool has_edges = std::filesystem::exists(edge_path, ignored);
  const std::string edge_text = has_edges ? read_file(edge_path) : "";
  const std::string ele_path = with_suffix(path, ".ele");
  const bool is_cloud = file_suffix(path) == ".node" && !std::filesystem::exists(ele_path, ignored);
  const std::string ele_text = is_cloud ? "0 3 0\n" : read_file(ele_path);
  return parse_triangle_mesh(read_file(with_suffix(path, ".node")), ele_text, edge_text, with_suffix(path, ""));
}

void write_triangle_mesh(const std::string& path, const Mesh& mesh) {
  assert(mesh.labels.size() == mesh.edges.size() && mesh.regions.size() == mesh.triangles.size());
  write_node(with_suffix(path, ".node"), mesh);
  write_ele(with_suffix(path, ".ele"), mesh);
  write_edge(with_suffix(path, ".edge"), mesh);
}

}  // namespace parmesan
