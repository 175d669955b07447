#include <array>

#include "mesher/io/msh_sections.h"

namespace parmesan {
namespace {

std::array<double, 3> read_coordinates(MshInput& in) {
  std::array<double, 3> p{};
  for (double& coordinate : p) coordinate = in.real("a coordinate");
  return p;
}

void read_block(MshInput& in, MshContent& content) {
  const int dimension = in.integer("the dimension of an entity");
  if (dimension < 0 || dimension > 3) in.fail("the dimension of an entity must be 0 to 3");
  in.integer("the tag of an entity");
  const int num_parameters = in.integer("whether nodes have parameters") != 0 ? dimension : 0;
  const std::size_t count = in.count("the number of nodes of a block", 4);
  for (std::size_t i = 0; i < count; ++i) content.node_tags.add(in.size("the tag of a node"));
  for (std::size_t i = 0; i < count; ++i) {
    content.nodes.push_back(read_coordinates(in));
    for (int k = 0; k < num_parameters; ++k) in.real("a parameter of a node");
  }
}

void read_blocks(MshInput& in, MshContent& content) {
  in.start_numbers();
  const std::size_t num_blocks = in.count("the number of blocks of nodes", 4);
  content.nodes.reserve(in.count("the number of nodes", 4));
  in.size("the smallest tag");
  in.size("the largest tag");
  for (std::size_t i = 0; i < num_blocks; ++i) read_block(in, content);
  in.end_numbers();
}

/// Format 2.
void read_node_rows(MshInput& in, MshContent& content) {
  const std::size_t count = in.text_count("the number of nodes", 4);
  content.nodes.reserve(count);
  in.start_numbers();
  for (std::size_t i = 0; i < count; ++i) {
    content.node_tags.add(in.integer("the number of a node"));
    content.nodes.push_back(read_coordinates(in));
  }
  in.end_numbers();
}

}  // namespace

void read_msh_nodes(MshInput& in, MshContent& content) {
  if (in.is_version_2()) {
    read_node_rows(in, content);
  } else {
    read_blocks(in, content);
  }
  if (!content.node_tags.finish()) in.fail("two nodes have the same tag");
}

}  // namespace parmesan
