#include "mesher/io/msh_sections.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "mesher/index.h"
#include "mesher/io/utf8.h"

namespace parmesan {
namespace {

using EntityCounts = std::array<std::size_t, 4>;  // by dimension

EntityCounts read_entity_counts(MshInput& in) {
  EntityCounts counts{};
  for (std::size_t& count : counts) count = in.count("the number of entities", 2);
  return counts;
}

/// Its first physical group, 0 where it has none; its bounds and what is around it are read over.
int read_entity_group(MshInput& in, int dimension) {
  const int num_coordinates = dimension == 0 ? 3 : 6;
  for (int i = 0; i < num_coordinates; ++i) in.real("a bound of an entity");
  const std::size_t num_groups = in.count("the number of groups of an entity", 1);
  int first = 0;
  for (std::size_t i = 0; i < num_groups; ++i) {
    const int group = read_msh_group(in, "the group of an entity");
    if (i == 0) first = group;
  }
  if (dimension == 0) return first;
  const std::size_t num_bounding = in.count("the number of entities around an entity", 1);
  for (std::size_t i = 0; i < num_bounding; ++i) in.integer("an entity around an entity");
  return first;
}

void read_entity(MshInput& in, int dimension, MshEntityGroups& groups) {
  const int tag = in.integer("the tag of an entity");
  groups[{dimension, tag}] = MshGroup{read_entity_group(in, dimension), tag};
}

void read_partitioned_entity(MshInput& in, int dimension, MshEntityGroups& groups) {
  const int tag = in.integer("the tag of an entity");
  const int parent_dimension = in.integer("the dimension of a parent");
  const int parent = in.integer("the tag of a parent");
  const std::size_t num_partitions = in.count("the number of partitions of an entity", 1);
  for (std::size_t i = 0; i < num_partitions; ++i) in.integer("a partition of an entity");
  const int physical = read_entity_group(in, dimension);
  std::optional<MshGroup>& group = groups[{dimension, tag}];
  if (parent_dimension == dimension)
    group = MshGroup{physical, parent};
  else
    group.reset();
}

/// The first of the strings with which a field begins.
std::string read_field_name(MshInput& in) {
  std::string name;
  const std::size_t num_strings = in.text_count("the number of strings", 1);
  for (std::size_t i = 0; i < num_strings; ++i) {
    const std::string_view text = in.word("a string");
    if (i == 0) name = text.size() >= 2 && text.front() == '"' ? text.substr(1, text.size() - 2) : text;
  }
  return name;
}

void read_values(MshInput& in, std::size_t count, MshField& field) {
  in.start_numbers();
  for (std::size_t i = 0; i < count; ++i) {
    field.tags.push_back(in.integer("the tag of a value"));
    for (int k = 0; k < field.components; ++k) field.values.push_back(in.real("a value"));
  }
  in.end_numbers();
}

}  // namespace

int read_msh_group(MshInput& in, const char* what) {
  const int group = in.integer(what);
  if (group == INT32_MIN) in.fail("the number of a group is out of range");
  return std::abs(group);
}

void read_msh_names(MshInput& in, MshContent& content) {
  const std::size_t count = in.text_count("the number of names", 3);
  for (std::size_t i = 0; i < count; ++i) {
    const int dimension = in.text_integer("the dimension of a group");
    const int number = in.text_integer("the number of a group");
    const std::string_view name = in.word("the name of a group");
    if (name.size() < 2 || name.front() != '"') in.fail("the name of a group must stand in double quotes");
    if (!is_utf8(name)) in.fail("the name of a group has bytes that are not UTF-8");
    content.physical_names[{dimension, number}] = name.substr(1, name.size() - 2);
  }
}

void read_msh_entities(MshInput& in, MshEntityGroups& groups) {
  in.start_numbers();
  const EntityCounts counts = read_entity_counts(in);
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::size_t i = 0; i < counts[at(dimension)]; ++i) read_entity(in, dimension, groups);
  in.end_numbers();
}

void read_msh_partitioned_entities(MshInput& in, MshEntityGroups& groups) {
  in.start_numbers();
  in.size("the number of partitions");
  const std::size_t num_ghosts = in.count("the number of ghost entities", 2);
  for (std::size_t i = 0; i < num_ghosts; ++i) {
    in.integer("the tag of a ghost entity");
    in.integer("the partition of a ghost entity");
  }
  const EntityCounts counts = read_entity_counts(in);
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::size_t i = 0; i < counts[at(dimension)]; ++i) read_partitioned_entity(in, dimension, groups);
  in.end_numbers();
}

MshField read_msh_field(MshInput& in) {
  MshField field;
  field.name = read_field_name(in);
  const std::size_t num_reals = in.text_count("the number of reals", 1);
  for (std::size_t i = 0; i < num_reals; ++i) in.text_real("a real");
  const std::size_t num_integers = in.text_count("the number of integers", 1);
  if (num_integers < 3) in.fail("the number of integers must be at least 3");
  in.text_integer("the time step");
  field.components = in.text_integer("the number of components");
  if (field.components != 1 && field.components != 3 && field.components != 9) {
    in.fail("the number of components must be 1, 3 or 9");
  }
  const std::size_t count = in.text_count("the number of values", 1);
  for (std::size_t i = 3; i < num_integers; ++i) in.text_integer("an integer");
  read_values(in, count, field);
  return field;
}

}  // namespace parmesan
