#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "mesher/io/msh_sections.h"

namespace parmesan {
namespace {

constexpr int line_type = 1;
constexpr int triangle_type = 2;
constexpr int point_type = 15;

/// read_node gives the tag of a node.
struct ElementHead {
  int type;
  std::int64_t tag;
  std::optional<MshGroup> group;  // nothing: the element is read over
};

template <std::size_t N, class ReadNode>
void read_nodes(MshInput& in, const TagMap& node_tags, const ElementHead& head, const ReadNode& read_node,
                MshElements<N>& elements) {
  std::array<int, N> nodes{};
  for (int& node : nodes) {
    const std::int64_t node_tag = read_node();
    node = node_tags.index(node_tag);
    if (node < 0) in.fail_value("there is no node " + std::to_string(node_tag));
  }
  if (!head.group) return;
  elements.tags.push_back(head.tag);
  elements.nodes.push_back(nodes);
  elements.groups.push_back(*head.group);
}

template <class ReadNode>
void read_element(MshInput& in, const ElementHead& head, const ReadNode& read_node, MshContent& content) {
  if (head.type == line_type) {
    read_nodes(in, content.node_tags, head, read_node, content.lines);
  } else if (head.type == triangle_type) {
    read_nodes(in, content.node_tags, head, read_node, content.triangles);
  } else if (head.type == point_type) {
    read_nodes(in, content.node_tags, head, read_node, content.points);
  } else {
    in.fail("has elements of type " + std::to_string(head.type) +
            "; points, lines and triangles of first order (15, 1, 2) are read");
  }
}

void read_block(MshInput& in, const MshEntityGroups& groups, MshContent& content) {
  const int dimension = in.integer("the dimension of an entity");
  const int entity = in.integer("the tag of an entity");
  const int type = in.integer("the type of elements");
  const auto found = groups.find({dimension, entity});
  const std::optional<MshGroup> group = found == groups.end() ? MshGroup{0, entity} : found->second;
  const std::size_t count = in.count("the number of elements of a block", 2);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t tag = in.size("the tag of an element");
    read_element(
        in, {type, tag, group}, [&in] { return in.size("the node of an element"); }, content);
  }
}

void read_blocks(MshInput& in, const MshEntityGroups& groups, MshContent& content) {
  in.start_numbers();
  const std::size_t num_blocks = in.count("the number of blocks of elements", 4);
  in.count("the number of elements", 2);
  in.size("the smallest tag");
  in.size("the largest tag");
  for (std::size_t i = 0; i < num_blocks; ++i) read_block(in, groups, content);
  in.end_numbers();
}

// Format 2.

int read_num_tags(MshInput& in) {
  const int num_tags = in.integer("the number of tags");
  if (num_tags < 0) in.fail("the number of tags is negative");
  return num_tags;
}

/// The tags of an element are its group, its entity, and what is skipped; then come its nodes.
void read_tags_and_nodes(MshInput& in, int type, int tag, int num_tags, MshContent& content) {
  MshGroup group;
  if (num_tags > 0) group.physical = read_msh_group(in, "the group of an element");
  if (num_tags > 1) group.entity = in.integer("the entity of an element");
  for (int i = 2; i < num_tags; ++i) in.integer("a tag of an element");
  read_element(
      in, {type, tag, group}, [&in] { return in.integer("the node of an element"); }, content);
}

void read_element_rows(MshInput& in, MshContent& content) {
  const std::size_t count = in.text_count("the number of elements", 4);
  for (std::size_t i = 0; i < count; ++i) {
    const int tag = in.integer("the number of an element");
    const int type = in.integer("the type of an element");
    const int num_tags = read_num_tags(in);
    read_tags_and_nodes(in, type, tag, num_tags, content);
  }
}

/// In a binary file elements that follow each other have a common head.
void read_binary_runs(MshInput& in, MshContent& content) {
  std::size_t left = in.text_count("the number of elements", 1);
  in.start_numbers();
  while (left > 0) {
    const int type = in.integer("the type of elements");
    const int count = in.integer("the number of elements of a run");
    const int num_tags = read_num_tags(in);
    if (count < 1 || static_cast<std::size_t>(count) > left) in.fail("the runs have not the number of elements");
    left -= static_cast<std::size_t>(count);
    for (int i = 0; i < count; ++i) {
      const int tag = in.integer("the number of an element");
      read_tags_and_nodes(in, type, tag, num_tags, content);
    }
  }
  in.end_numbers();
}

}  // namespace

void read_msh_elements(MshInput& in, const MshEntityGroups& groups, MshContent& content) {
  if (!in.is_version_2()) {
    read_blocks(in, groups, content);
  } else if (in.is_binary()) {
    read_binary_runs(in, content);
  } else {
    read_element_rows(in, content);
  }
}

}  // namespace parmesan
