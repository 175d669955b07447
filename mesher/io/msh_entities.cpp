#include "mesher/io/msh_entities.h"

#include <algorithm>
#include <map>
#include <utility>

namespace parmesan {

namespace {

/// For each label the lowest of the same name: readers that go by names would lose all but one.
std::map<int, int> first_of_name(const std::vector<int>& labels, const LabelNames& names) {
  std::map<std::string, int> first;
  std::map<int, int> result;
  for (const int label : ascending(labels))
    result[label] = names.contains(label) ? first.try_emplace(names.at(label), label).first->second : label;
  return result;
}

}  // namespace

std::vector<MshEntity> msh_entities_of(const std::vector<int>& labels, const LabelNames& names) {
  const std::map<int, int> first = first_of_name(labels, names);
  std::map<int, MshEntity> by_label;
  for (std::size_t i = 0; i < labels.size(); ++i) by_label[first.at(labels[i])].members.push_back(static_cast<int>(i));
  int next_free = 1;
  const auto take_free = [&by_label, &next_free] {
    while (by_label.contains(next_free)) ++next_free;
    return next_free++;
  };
  std::vector<MshEntity> entities;
  for (auto& [label, entity] : by_label) {
    const bool has_name = names.contains(label);
    entity.number = label < 1 ? take_free() : label;
    if (has_name || label < 1) entity.name = label_name(names, label);
    entities.push_back(std::move(entity));
  }
  return entities;
}

std::vector<MshEntity> msh_entity_of_isolated_points(const Mesh& mesh) {
  if (!mesh.triangles.empty()) return {};
  const std::vector<int> ends = ends_of_edges(mesh);
  MshEntity entity;
  entity.number = 1;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (!std::ranges::binary_search(ends, v)) entity.members.push_back(v);
  if (entity.members.empty()) return {};
  return {std::move(entity)};
}

}  // namespace parmesan
