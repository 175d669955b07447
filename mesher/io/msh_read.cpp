#include <string>
#include <utility>

#include "mesher/errors.h"
#include "mesher/io/msh.h"
#include "mesher/io/msh_content.h"
#include "mesher/io/msh_input.h"
#include "mesher/io/msh_sections.h"

namespace parmesan {
namespace {

/// Reads the sections of a file in their order, those that it does not know excepted.
class MshReader {
 public:
  MshReader(std::string_view bytes, const std::string& name) : in_(bytes, name) {}

  MshContent read() {
    while (!in_.at_end()) {
      const std::string section(in_.word("a section"));
      if (section.front() != '$') in_.fail("a section should begin here, like $Nodes; is a count too small?");
      read_section(section);
      const std::string end = "$End" + section.substr(1);
      if (in_.word(end.c_str()) != end) in_.fail(end + " should stand here; is a count too small?");
    }
    if (!has_elements_) in_.fail("the section $Elements is missing; is the file cut off?");
    return std::move(content_);
  }

 private:
  void read_section(const std::string& section) {
    if (section == "$PhysicalNames") {
      read_msh_names(in_, content_);
    } else if (section == "$Entities" && !in_.is_version_2()) {
      read_msh_entities(in_, groups_);
    } else if (section == "$PartitionedEntities" && !in_.is_version_2()) {
      read_msh_partitioned_entities(in_, groups_);
    } else if (section == "$Nodes") {
      begin_only_once(has_nodes_);
      read_msh_nodes(in_, content_);
    } else if (section == "$ParametricNodes") {
      in_.fail("nodes with parameters are read in format 4.1 only; without Gmsh's Mesh.SaveParametric there are none");
    } else if (section == "$Elements") {
      require(has_nodes_, "$Nodes must come before $Elements");
      begin_only_once(has_elements_);
      read_msh_elements(in_, groups_, content_);
    } else if (section == "$NodeData") {
      require(has_nodes_, "$Nodes must come before $NodeData");
      content_.node_fields.push_back(read_msh_field(in_));
    } else if (section == "$ElementData") {
      require(has_elements_, "$Elements must come before $ElementData");
      content_.element_fields.push_back(read_msh_field(in_));
    } else {
      in_.skip_to_line("$End" + section.substr(1));
    }
  }

  void require(bool holds, const char* problem) const {
    if (!holds) in_.fail(problem);
  }

  void begin_only_once(bool& has_begun) const {
    require(!has_begun, "the same section a second time");
    has_begun = true;
  }

  MshInput in_;
  MshContent content_;
  MshEntityGroups groups_;
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
