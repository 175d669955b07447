#include <cstdlib>
#include <utility>

#include "mesher/errors.h"
#include "mesher/io/msh.h"
#include "mesher/io/msh_content.h"
#include "mesher/io/msh_input.h"

namespace parmesan {
namespace {

constexpr int line_type = 1;
constexpr int triangle_type = 2;
constexpr int point_type = 15;

/// Reads the sections of a file, each in its version's way, into a MshContent.
class MshReader {
 public:
  MshReader(std::string_view bytes, const std::string& name) : in_(bytes, name) {}

  MshContent read() {
    while (!in_.at_end()) {
      const std::string section(in_.word("a section"));
      if (section.front() != '$') in_.fail("a section should begin here, like $Nodes; is a count too small?");
      read_section(section);
    }
    if (!has_elements_) in_.fail("the section $Elements is missing; is the file cut off?");
    return std::move(content_);
  }

 private:
  void read_section(const std::string& section) {
    const std::string end = "$End" + section.substr(1);
    if (section == "$PhysicalNames") {
      read_physical_names();
    } else if (section == "$Entities" && !in_.is_version_2()) {
      read_entities();
    } else if (section == "$Nodes") {
      read_nodes();
    } else if (section == "$Elements") {
      read_elements();
    } else if (section == "$NodeData") {
      if (!has_nodes_) in_.fail("$Nodes must come before $NodeData");
      content_.node_fields.push_back(read_field());
    } else if (section == "$ElementData") {
      if (!has_elements_) in_.fail("$Elements must come before $ElementData");
      content_.element_fields.push_back(read_field());
    } else {
      in_.skip_to_line(end);
    }
    if (in_.word(end.c_str()) != end) in_.fail(end + " should stand here; is a count too small?");
  }

  void read_physical_names() {
    const std::size_t count = in_.text_count("the number of names", 3);
    for (std::size_t i = 0; i < count; ++i) {
      const int dimension = in_.text_integer("the dimension of a group");
      const int number = in_.text_integer("the number of a group");
      std::string_view name = in_.word("the name of a group");
      if (name.size() < 2 || name.front() != '"') in_.fail("the name of a group must stand in double quotes");
      content_.physical_names[{dimension, number}] = name.substr(1, name.size() - 2);
    }
  }

  // Format 4.1.

  void read_entities() {
    in_.start_numbers();
    std::array<std::size_t, 4> counts{};
    for (std::size_t& count : counts) count = in_.count("the number of entities", 2);
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (std::size_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) read_entity(dimension);
    }
    in_.end_numbers();
  }

  void read_entity(int dimension) {
    const int tag = in_.integer("the tag of an entity");
    const int num_coordinates = dimension == 0 ? 3 : 6;
    for (int i = 0; i < num_coordinates; ++i) in_.real("a bound of an entity");
    const std::size_t num_groups = in_.count("the number of groups of an entity", 1);
    for (std::size_t i = 0; i < num_groups; ++i) {
      const int group = in_.integer("the group of an entity");
      if (i == 0) physical_of_[{dimension, tag}] = checked_group(group);
    }
    if (dimension == 0) return;
    const std::size_t num_bounding = in_.count("the number of entities around an entity", 1);
    for (std::size_t i = 0; i < num_bounding; ++i) in_.integer("an entity around an entity");
  }

  /// Negative numbers are Gmsh's way to say that the elements are turned.
  int checked_group(int group) const {
    if (group == INT32_MIN) in_.fail("the number of a group is out of range");
    return std::abs(group);
  }

  void read_nodes() {
    if (has_nodes_) in_.fail("the same section a second time");
    has_nodes_ = true;
    if (in_.is_version_2()) {
      read_nodes_2();
    } else {
      read_nodes_4();
    }
    if (!content_.node_tags.finish()) in_.fail("two nodes have the same tag");
  }

  std::array<double, 3> read_coordinates() {
    std::array<double, 3> p{};
    for (double& coordinate : p) coordinate = in_.real("a coordinate");
    return p;
  }

  void read_nodes_4() {
    in_.start_numbers();
    const std::size_t num_blocks = in_.count("the number of blocks of nodes", 4);
    content_.nodes.reserve(in_.count("the number of nodes", 4));
    in_.size("the smallest tag");
    in_.size("the largest tag");
    for (std::size_t i = 0; i < num_blocks; ++i) read_block_of_nodes();
    in_.end_numbers();
  }

  void read_block_of_nodes() {
    const int dimension = in_.integer("the dimension of an entity");
    if (dimension < 0 || dimension > 3) in_.fail("the dimension of an entity must be 0 to 3");
    in_.integer("the tag of an entity");
    const int num_parameters = in_.integer("whether nodes have parameters") != 0 ? dimension : 0;
    const std::size_t count = in_.count("the number of nodes of a block", 4);
    for (std::size_t i = 0; i < count; ++i) content_.node_tags.add(in_.size("the tag of a node"));
    for (std::size_t i = 0; i < count; ++i) {
      content_.nodes.push_back(read_coordinates());
      for (int k = 0; k < num_parameters; ++k) in_.real("a parameter of a node");
    }
  }

  void read_elements() {
    if (!has_nodes_) in_.fail("$Nodes must come before $Elements");
    if (has_elements_) in_.fail("the same section a second time");
    has_elements_ = true;
    if (!in_.is_version_2()) {
      read_elements_4();
    } else if (in_.is_binary()) {
      read_binary_elements_2();
    } else {
      read_text_elements_2();
    }
  }

  void read_elements_4() {
    in_.start_numbers();
    const std::size_t num_blocks = in_.count("the number of blocks of elements", 4);
    in_.count("the number of elements", 2);
    in_.size("the smallest tag");
    in_.size("the largest tag");
    for (std::size_t i = 0; i < num_blocks; ++i) {
      const int dimension = in_.integer("the dimension of an entity");
      const int entity = in_.integer("the tag of an entity");
      const int type = in_.integer("the type of elements");
      const auto found = physical_of_.find({dimension, entity});
      const MshGroup group{found == physical_of_.end() ? 0 : found->second, entity};
      const std::size_t count = in_.count("the number of elements of a block", 2);
      for (std::size_t k = 0; k < count; ++k) {
        const std::int64_t tag = in_.size("the tag of an element");
        read_element(type, tag, group, [this] { return in_.size("the node of an element"); });
      }
    }
    in_.end_numbers();
  }

  /// The nodes of an element; read_node gives their tags.
  template <class ReadNode>
  void read_element(int type, std::int64_t tag, MshGroup group, const ReadNode& read_node) {
    if (type == line_type) {
      read_nodes_of(content_.lines, tag, group, read_node);
    } else if (type == triangle_type) {
      read_nodes_of(content_.triangles, tag, group, read_node);
    } else if (type == point_type) {
      read_node();
    } else {
      in_.fail("has elements of type " + std::to_string(type) +
               "; points, lines and triangles of first order (15, 1, 2) are read");
    }
  }

  template <std::size_t N, class ReadNode>
  void read_nodes_of(MshElements<N>& elements, std::int64_t tag, MshGroup group, const ReadNode& read_node) {
    std::array<int, N> nodes{};
    for (int& node : nodes) {
      const std::int64_t node_tag = read_node();
      node = content_.node_tags.index(node_tag);
      if (node < 0) in_.fail("there is no node " + std::to_string(node_tag));
    }
    elements.tags.push_back(tag);
    elements.nodes.push_back(nodes);
    elements.groups.push_back(group);
  }

  // Format 2.

  void read_nodes_2() {
    const std::size_t count = in_.text_count("the number of nodes", 4);
    content_.nodes.reserve(count);
    in_.start_numbers();
    for (std::size_t i = 0; i < count; ++i) {
      content_.node_tags.add(in_.integer("the number of a node"));
      content_.nodes.push_back(read_coordinates());
    }
    in_.end_numbers();
  }

  /// The tags of an element: its group, its entity, and what is skipped.
  MshGroup read_tags(int num_tags) {
    MshGroup group;
    for (int i = 0; i < num_tags; ++i) {
      const int tag = in_.integer("a tag of an element");
      if (i == 0) group.physical = checked_group(tag);
      if (i == 1) group.entity = tag;
    }
    return group;
  }

  int read_num_tags() {
    const int num_tags = in_.integer("the number of tags");
    if (num_tags < 0) in_.fail("the number of tags is negative");
    return num_tags;
  }

  void read_text_elements_2() {
    const std::size_t count = in_.text_count("the number of elements", 4);
    for (std::size_t i = 0; i < count; ++i) {
      const int tag = in_.integer("the number of an element");
      const int type = in_.integer("the type of an element");
      const MshGroup group = read_tags(read_num_tags());
      read_element(type, tag, group, [this] { return in_.integer("the node of an element"); });
    }
  }

  void read_binary_elements_2() {
    std::size_t left = in_.text_count("the number of elements", 1);
    in_.start_numbers();
    while (left > 0) {
      const int type = in_.integer("the type of elements");
      const int count = in_.integer("the number of elements of a block");
      const int num_tags = read_num_tags();
      if (count < 1 || static_cast<std::size_t>(count) > left) in_.fail("the blocks have not the number of elements");
      left -= static_cast<std::size_t>(count);
      for (int i = 0; i < count; ++i) {
        const int tag = in_.integer("the number of an element");
        const MshGroup group = read_tags(num_tags);
        read_element(type, tag, group, [this] { return in_.integer("the node of an element"); });
      }
    }
    in_.end_numbers();
  }

  // Both.

  MshField read_field() {
    MshField field;
    const std::size_t num_strings = in_.text_count("the number of strings", 1);
    for (std::size_t i = 0; i < num_strings; ++i) {
      const std::string_view text = in_.word("a string");
      if (i == 0) field.name = text.size() >= 2 && text.front() == '"' ? text.substr(1, text.size() - 2) : text;
    }
    const std::size_t num_reals = in_.text_count("the number of reals", 1);
    for (std::size_t i = 0; i < num_reals; ++i) in_.text_real("a real");
    const std::size_t num_integers = in_.text_count("the number of integers", 1);
    if (num_integers < 3) in_.fail("the number of integers must be at least 3");
    in_.text_integer("the time step");
    field.components = in_.text_integer("the number of components");
    if (field.components != 1 && field.components != 3 && field.components != 9) {
      in_.fail("the number of components must be 1, 3 or 9");
    }
    const std::size_t count = in_.text_count("the number of values", 1);
    for (std::size_t i = 3; i < num_integers; ++i) in_.text_integer("an integer");
    read_values(count, field);
    return field;
  }

  void read_values(std::size_t count, MshField& field) {
    in_.start_numbers();
    for (std::size_t i = 0; i < count; ++i) {
      field.tags.push_back(in_.integer("the tag of a value"));
      for (int k = 0; k < field.components; ++k) field.values.push_back(in_.real("a value"));
    }
    in_.end_numbers();
  }

  MshInput in_;
  MshContent content_;
  std::map<std::pair<int, int>, int> physical_of_;  // first group of an entity, by dimension and tag
  bool has_nodes_ = false;
  bool has_elements_ = false;
};

}  // namespace

MeshData parse_msh(std::string_view bytes, const std::string& name) {
  MshContent content = MshReader(bytes, name).read();
  try {
    return mesh_data_of(std::move(content));
  } catch (const InputError& error) {
    throw FileError(name, 0, error.what());
  }
}

MeshData read_msh(const std::string& path) { return parse_msh(read_file(path), path); }

}  // namespace parmesan
