#include <cassert>
#include <utility>
#include <vector>

#include "mesher/io/medit.h"
#include "mesher/io/medit_keywords.h"
#include "mesher/io/output_file.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

/// The sections of a Medit mesh may come in any order: those that need another one first are
/// bookmarked and read at the end. Edges and triangles may come in several, as meshio writes them.
class MeditMeshReader {
 public:
  MeditMeshReader(std::string_view text, const std::string& name) : in_(text, name) { mesh_.first_number = 1; }

  Mesh read() {
    read_medit_version(in_);
    for (std::string keyword = read_medit_keyword(in_); keyword != "end"; keyword = read_medit_keyword(in_)) {
      read_section(keyword);
    }
    if (dimension_ == 0) in_.fail("the keyword Dimension is missing");
    if (vertices_.state == State::Missing) in_.fail("the keyword Vertices is missing");
    if (vertices_.state == State::Bookmarked) read_vertices(vertices_.start);
    for (TextReader& in : edges_) read_edges(in);
    for (TextReader& in : triangles_) read_triangles(in);
    read_required_parts();
    return std::move(mesh_);
  }

 private:
  enum class State { Missing, Bookmarked, Read };
  struct Section {
    State state = State::Missing;
    TextReader start;
  };

  void read_section(const std::string& keyword) {
    if (keyword == "dimension") {
      dimension_ = read_medit_dimension(in_);
    } else if (keyword == "vertices") {
      if (starts(vertices_, dimension_ != 0)) read_vertices(in_);
    } else if (keyword == "edges") {
      if (can_be_read(edges_)) read_edges(in_);
    } else if (keyword == "triangles") {
      if (can_be_read(triangles_)) read_triangles(in_);
    } else if (keyword == "requiredvertices") {
      starts(required_vertices_, false);
    } else if (keyword == "requirededges") {
      starts(required_edges_, false);
    } else if (keyword == "requiredtriangles") {
      starts(required_triangles_, false);
    } else {
      const bool elements = keyword == "quadrilaterals" || keyword == "tetrahedra" || keyword == "hexahedra";
      if (elements && in_.count("the number of elements", 1) > 0) in_.fail("has elements that are not triangles");
      in_.skip_to_keyword();
    }
  }

  /// Whether the section is to be read at once; bookmarks and skips it otherwise.
  bool starts(Section& section, bool can_be_read) {
    if (section.state != State::Missing) in_.fail("the same keyword a second time");
    section = {can_be_read ? State::Read : State::Bookmarked, in_};
    if (!can_be_read) in_.skip_to_keyword();
    return can_be_read;
  }

  /// Whether one of several sections is to be read at once, after those before it; bookmarks and skips it otherwise.
  bool can_be_read(std::vector<TextReader>& bookmarks) {
    if (vertices_.state == State::Read && bookmarks.empty()) return true;
    bookmarks.push_back(in_);
    in_.skip_to_keyword();
    return false;
  }

  void read_vertices(TextReader& in) {
    mesh_.points.resize(static_cast<std::size_t>(in.count("the number of vertices", dimension_ + 1)));
    for (Point& point : mesh_.points) {
      point.x = in.real("the x coordinate");
      point.y = in.real("the y coordinate");
      if (dimension_ == 3 && in.real("the z coordinate") != 0.0) in.fail("z is not 0: the mesh must lie in the plane");
      in.integer("the vertex reference");
    }
  }

  void read_edges(TextReader& in) {
    const std::size_t first = mesh_.edges.size();
    const std::size_t last = first + static_cast<std::size_t>(in.count("the number of edges", 3));
    mesh_.edges.resize(last);
    mesh_.labels.resize(last);
    for (std::size_t i = first; i < last; ++i) {
      for (int& vertex : mesh_.edges[i]) vertex = in.index("the vertex of an edge", 1, mesh_.num_vertices());
      mesh_.labels[i] = in.integer("the edge reference");
    }
  }

  void read_triangles(TextReader& in) {
    const std::size_t first = mesh_.triangles.size();
    const std::size_t last = first + static_cast<std::size_t>(in.count("the number of triangles", 4));
    mesh_.triangles.resize(last);
    mesh_.regions.resize(last);
    for (std::size_t i = first; i < last; ++i) {
      for (int& vertex : mesh_.triangles[i]) vertex = in.index("the vertex of a triangle", 1, mesh_.num_vertices());
      mesh_.regions[i] = in.integer("the triangle reference");
    }
  }

  void read_required_parts() {
    const auto read = [](Section& section, const char* what, int size) {
      std::vector<int> numbers;
      if (section.state == State::Missing) return numbers;
      numbers.resize(static_cast<std::size_t>(section.start.count("the number of required entities", 1)));
      for (int& number : numbers) number = section.start.index(what, 1, size);
      return ascending(std::move(numbers));
    };
    mesh_.required.vertices = read(required_vertices_, "a required vertex", mesh_.num_vertices());
    mesh_.required.edges = read(required_edges_, "a required edge", mesh_.num_edges());
    mesh_.required.triangles = read(required_triangles_, "a required triangle", mesh_.num_triangles());
  }

  TextReader in_;
  Section required_vertices_{State::Missing, in_};
  Section required_edges_{State::Missing, in_};
  Section required_triangles_{State::Missing, in_};
  Section vertices_{State::Missing, in_};
  std::vector<TextReader> edges_;
  std::vector<TextReader> triangles_;
  int dimension_ = 0;
  Mesh mesh_;
};

void write_edges(OutputFile& out, const Mesh& mesh) {
  if (mesh.edges.empty()) return;
  out << "Edges\n" << mesh.edges.size() << '\n';
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    for (const int vertex : mesh.edges[i]) out << vertex + 1 << ' ';
    out << mesh.labels[i] << '\n';
  }
}

void write_triangles(OutputFile& out, const Mesh& mesh) {
  if (mesh.triangles.empty()) return;
  out << "Triangles\n" << mesh.triangles.size() << '\n';
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const int vertex : mesh.triangles[i]) out << vertex + 1 << ' ';
    out << mesh.regions[i] << '\n';
  }
}

void write_numbers(OutputFile& out, const char* keyword, const std::vector<int>& numbers) {
  if (numbers.empty()) return;
  out << keyword << '\n' << numbers.size() << '\n';
  for (const int number : numbers) out << number + 1 << '\n';
}

}  // namespace

Mesh parse_medit(std::string_view text, const std::string& name) { return MeditMeshReader(text, name).read(); }

Mesh read_medit(const std::string& path) { return parse_medit(read_file(path), path); }

void write_medit(const std::string& path, const Mesh& mesh) {
  assert(mesh.labels.size() == mesh.edges.size() && mesh.regions.size() == mesh.triangles.size());
  OutputFile out(path);
  out << "MeshVersionFormatted 2\nDimension 2\nVertices\n" << mesh.points.size() << '\n';
  for (const Point& point : mesh.points) out << point.x << ' ' << point.y << " 0\n";
  write_edges(out, mesh);
  write_triangles(out, mesh);
  write_numbers(out, "RequiredVertices", mesh.required.vertices);
  write_numbers(out, "RequiredEdges", mesh.required.edges);
  write_numbers(out, "RequiredTriangles", mesh.required.triangles);
  out << "End\n";
  out.commit();
}

}  // namespace parmesan
