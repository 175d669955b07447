#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

#include "mesher/index.h"
#include "mesher/io/msh.h"
#include "mesher/io/msh_entities.h"
#include "mesher/io/msh_numbers.h"
#include "mesher/io/output_file.h"
#include "mesher/io/picture/view.h"

namespace parmesan {
namespace {

/// Double quotes would end the name; line ends are for the reader's comfort.
std::string quoted(std::string name) {
  for (char& c : name) {
    if (c == '"') c = '\'';
    if (c == '\n' || c == '\r') c = ' ';
  }
  return '"' + name + '"';
}

class MshWriter {
 public:
  MshWriter(const std::string& path, const Mesh& mesh, Encoding encoding)
      : out_(path),
        numbers_(out_, encoding),
        mesh_(mesh),
        encoding_(encoding),
        points_(msh_entity_of_isolated_points(mesh)),
        lines_(msh_entities_of(mesh.labels, mesh.label_names)),
        surfaces_(msh_entities_of(mesh.regions, mesh.region_names)) {}

  void write(const MeshFields& fields) {
    write_format();
    write_names();
    write_entities();
    write_nodes();
    write_elements();
    for (const MeshField& field : fields.points) write_field("NodeData", field, 1);
    for (const MeshField& field : fields.cells) write_field("ElementData", field, mesh_.edges.size() + 1);
    write_required();
    out_.commit();
  }

 private:
  void write_format() {
    out_ << "$MeshFormat\n4.1 " << (encoding_ == Encoding::Text ? 0 : 1) << " 8\n";
    if (encoding_ == Encoding::Binary) {
      numbers_.integer(1);
      numbers_.finish();
    }
    out_ << "$EndMeshFormat\n";
  }

  void write_names() {
    const auto has_name = [](const MshEntity& group) { return !group.name.empty(); };
    const auto count = std::count_if(lines_.begin(), lines_.end(), has_name) +
                       std::count_if(surfaces_.begin(), surfaces_.end(), has_name);
    if (count == 0) return;
    out_ << "$PhysicalNames\n" << static_cast<std::size_t>(count) << '\n';
    for (const MshEntity& group : lines_) write_name(1, group);
    for (const MshEntity& group : surfaces_) write_name(2, group);
    out_ << "$EndPhysicalNames\n";
  }

  void write_name(int dimension, const MshEntity& group) {
    if (!group.name.empty()) out_ << dimension << ' ' << group.number << ' ' << quoted(group.name) << '\n';
  }

  void write_entities() {
    out_ << "$Entities\n";
    numbers_.size(points_.size());
    numbers_.size(lines_.size());
    numbers_.size(surfaces_.size());
    numbers_.size(0);
    numbers_.end_row();
    const Bounds bounds = bounds_of(mesh_);
    for (const MshEntity& group : points_) write_point_entity(group);
    for (const MshEntity& group : lines_) write_entity(group, bounds);
    for (const MshEntity& group : surfaces_) write_entity(group, bounds);
    numbers_.finish();
    out_ << "$EndEntities\n";
  }

  void write_point_entity(const MshEntity& group) {
    numbers_.integer(group.number);
    write_place(mesh_.points[at(group.members.front())]);
    numbers_.size(1);
    numbers_.integer(group.number);
    numbers_.end_row();
  }

  void write_place(const Point& p) {
    numbers_.real(p.x);
    numbers_.real(p.y);
    numbers_.real(0.0);
  }

  /// With the bounds of the whole mesh, and nothing around it: Gmsh works them out.
  void write_entity(const MshEntity& group, const Bounds& bounds) {
    numbers_.integer(group.number);
    write_place(bounds.low);
    write_place(bounds.high);
    numbers_.size(1);
    numbers_.integer(group.number);
    numbers_.size(0);
    numbers_.end_row();
  }

  void write_counts(std::size_t blocks, std::size_t entities) {
    numbers_.size(blocks);
    numbers_.size(entities);
    numbers_.size(entities == 0 ? 0 : 1);
    numbers_.size(entities);
    numbers_.end_row();
  }

  /// All nodes belong to one surface, or line.
  void write_nodes() {
    out_ << "$Nodes\n";
    const std::size_t n = mesh_.points.size();
    write_counts(n == 0 ? 0 : 1, n);
    if (n > 0) write_block_of_nodes();
    numbers_.finish();
    out_ << "$EndNodes\n";
  }

  void write_block_of_nodes() {
    const std::vector<MshEntity>& owners = surfaces_.empty() ? lines_ : surfaces_;
    numbers_.integer(surfaces_.empty() ? 1 : 2);
    numbers_.integer(owners.empty() ? 1 : owners.front().number);
    numbers_.integer(0);
    numbers_.size(mesh_.points.size());
    numbers_.end_row();
    for (std::size_t i = 0; i < mesh_.points.size(); ++i) {
      numbers_.size(i + 1);
      numbers_.end_row();
    }
    for (const Point& p : mesh_.points) {
      write_place(p);
      numbers_.end_row();
    }
  }

  void write_elements() {
    out_ << "$Elements\n";
    const std::size_t num_points = points_.empty() ? 0 : points_.front().members.size();
    write_counts(points_.size() + lines_.size() + surfaces_.size(),
                 num_points + mesh_.edges.size() + mesh_.triangles.size());
    for (const MshEntity& group : points_) write_points(group);
    for (const MshEntity& group : lines_) write_block(1, 1, group, mesh_.edges, 1);
    for (const MshEntity& group : surfaces_) write_block(2, 2, group, mesh_.triangles, mesh_.edges.size() + 1);
    numbers_.finish();
    out_ << "$EndElements\n";
  }

  /// Tagged after the lines, to which fields and marks count from 1.
  void write_points(const MshEntity& group) {
    write_block_head(0, 15, group);
    std::size_t tag = mesh_.edges.size();
    for (const int v : group.members) {
      numbers_.size(++tag);
      numbers_.size(static_cast<std::size_t>(v) + 1);
      numbers_.end_row();
    }
  }

  void write_block_head(int dimension, int type, const MshEntity& group) {
    numbers_.integer(dimension);
    numbers_.integer(group.number);
    numbers_.integer(type);
    numbers_.size(group.members.size());
    numbers_.end_row();
  }

  template <std::size_t N>
  void write_block(int dimension, int type, const MshEntity& group, const std::vector<std::array<int, N>>& elements,
                   std::size_t first_tag) {
    write_block_head(dimension, type, group);
    for (const int i : group.members) {
      numbers_.size(first_tag + static_cast<std::size_t>(i));
      for (const int vertex : elements[at(i)]) numbers_.size(static_cast<std::size_t>(vertex) + 1);
      numbers_.end_row();
    }
  }

  /// Lines and triangles in one field, as their tags follow each other.
  void write_required() {
    const RequiredParts& required = mesh_.required;
    const auto field = [](const std::vector<unsigned char>& marks) {
      return MeshField{kRequiredField, 1, {marks.begin(), marks.end()}};
    };
    if (!required.vertices.empty())
      write_field("NodeData", field(required_marks(required.vertices, mesh_.points.size())), 1);
    std::vector<unsigned char> elements = required_marks(required.edges, mesh_.edges.size());
    const std::vector<unsigned char> triangles = required_marks(required.triangles, mesh_.triangles.size());
    elements.insert(elements.end(), triangles.begin(), triangles.end());
    if (!required.edges.empty() || !required.triangles.empty()) write_field("ElementData", field(elements), 1);
  }

  void write_field(const char* section, const MeshField& field, std::size_t first_tag) {
    const std::vector<double> values = values_in_space(field);
    const auto components = static_cast<std::size_t>(components_in_space(field));
    const std::size_t count = values.size() / components;
    out_ << '$' << section << "\n1\n" << quoted(field.name) << "\n1\n0\n3\n0\n" << components << '\n' << count << '\n';
    for (std::size_t i = 0; i < count; ++i) {
      numbers_.integer(static_cast<int>(first_tag + i));
      for (std::size_t k = 0; k < components; ++k) numbers_.real(values[components * i + k]);
      numbers_.end_row();
    }
    numbers_.finish();
    out_ << "$End" << section << '\n';
  }

  OutputFile out_;
  MshNumbers numbers_;
  const Mesh& mesh_;
  Encoding encoding_;
  std::vector<MshEntity> points_;  // none or one
  std::vector<MshEntity> lines_;
  std::vector<MshEntity> surfaces_;
};

}  // namespace

void write_msh(const std::string& path, const Mesh& mesh, const MeshFields& fields, Encoding encoding) {
  assert(mesh.labels.size() == mesh.edges.size() && mesh.regions.size() == mesh.triangles.size());
  check_fields(fields, mesh);
  MshWriter(path, mesh, encoding).write(fields);
}

}  // namespace parmesan
