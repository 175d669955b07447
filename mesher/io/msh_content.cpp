#include "mesher/io/msh_content.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "mesher/errors.h"
#include "mesher/index.h"
#include "mesher/io/boundary_edges.h"

namespace parmesan {
namespace {

/// The elements at these places, in their order.
template <std::size_t N>
MshElements<N> selected(const MshElements<N>& elements, const std::vector<int>& places) {
  MshElements<N> result;
  for (const int i : places) {
    result.tags.push_back(elements.tags[at(i)]);
    result.nodes.push_back(elements.nodes[at(i)]);
    result.groups.push_back(elements.groups[at(i)]);
  }
  return result;
}

template <std::size_t N>
void sort_by_tag(MshElements<N>& elements) {
  if (std::is_sorted(elements.tags.begin(), elements.tags.end())) return;
  std::vector<int> order(elements.tags.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&elements](int a, int b) { return elements.tags[at(a)] < elements.tags[at(b)]; });
  elements = selected(elements, order);
}

/// Format 2 gives elements of several groups several times; the first one stays.
template <std::size_t N>
void drop_repeated(MshElements<N>& elements) {
  std::vector<std::pair<std::array<int, N>, int>> order;  // their nodes, ascending, and their places
  order.reserve(elements.nodes.size());
  for (std::array<int, N> nodes : elements.nodes) {
    std::sort(nodes.begin(), nodes.end());
    order.emplace_back(nodes, static_cast<int>(order.size()));
  }
  std::sort(order.begin(), order.end());
  const auto are_equal = [](const auto& one, const auto& other) { return one.first == other.first; };
  order.erase(std::unique(order.begin(), order.end(), are_equal), order.end());
  if (order.size() == elements.nodes.size()) return;
  std::vector<int> kept;
  kept.reserve(order.size());
  for (const auto& [nodes, place] : order) kept.push_back(place);
  std::sort(kept.begin(), kept.end());
  elements = selected(elements, kept);
}

/// The number that stands for a group of this name, when it is one that Gmsh's numbers cannot be.
bool is_number_below_1(const std::string& name, int& number) {
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() && number < 1;
}

/// The numbers of the entities, or 0 where there is only one.
std::vector<int> entities_of(const std::vector<MshGroup>& groups) {
  const bool is_one =
      std::all_of(groups.begin(), groups.end(), [&groups](MshGroup g) { return g.entity == groups[0].entity; });
  std::vector<int> labels(groups.size(), 0);
  if (is_one) return labels;
  std::transform(groups.begin(), groups.end(), labels.begin(), [](MshGroup g) { return g.entity; });
  return labels;
}

/// One label for each element; names: those of the labels.
std::vector<int> labels_of(const std::vector<MshGroup>& groups, int dimension, const MshContent& content,
                           LabelNames& names) {
  if (std::all_of(groups.begin(), groups.end(), [](MshGroup g) { return g.physical == 0; })) return entities_of(groups);
  std::map<int, int> label_of;
  for (const auto& [key, name] : content.physical_names) {
    if (key.first != dimension) continue;
    int number = 0;
    if (is_number_below_1(name, number)) {
      label_of[key.second] = number;
    } else {
      names[key.second] = name;
    }
  }
  std::vector<int> labels;
  labels.reserve(groups.size());
  for (const MshGroup& group : groups) {
    const auto found = label_of.find(group.physical);
    labels.push_back(found == label_of.end() ? group.physical : found->second);
  }
  return labels;
}

/// Leaves out the nodes that no element has; the indices of those that stay. Of points those of a geometry are kept
/// that are in a group.
std::vector<int> take_used_nodes(const MshContent& content, Mesh& mesh) {
  std::vector<int> renumbered(content.nodes.size(), -1);
  for (std::size_t i = 0; mesh.triangles.empty() && i < content.points.nodes.size(); ++i)
    if (content.points.groups[i].physical != 0) renumbered[at(content.points.nodes[i][0])] = 0;
  for (const auto& line : mesh.edges) {
    for (const int v : line) renumbered[at(v)] = 0;
  }
  for (const auto& triangle : mesh.triangles) {
    for (const int v : triangle) renumbered[at(v)] = 0;
  }
  std::vector<int> used;
  for (std::size_t i = 0; i < renumbered.size(); ++i) {
    if (renumbered[i] < 0) continue;
    const auto& [x, y, z] = content.nodes[i];
    if (z != 0.0) {
      throw InputError("node " + std::to_string(content.node_tags.tag(static_cast<int>(i))) +
                       " has a z that is not 0: the mesh must lie in the plane");
    }
    renumbered[i] = static_cast<int>(used.size());
    used.push_back(static_cast<int>(i));
    mesh.points.push_back({x, y});
  }
  for (auto& line : mesh.edges) {
    for (int& v : line) v = renumbered[at(v)];
  }
  for (auto& triangle : mesh.triangles) {
    for (int& v : triangle) v = renumbered[at(v)];
  }
  return used;
}

/// Gmsh has surfaces seen from either side. Returns what to tell where not all are turned.
std::vector<std::string> turn_clockwise_triangles(Mesh& mesh) {
  int count = 0, first = -1;
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    auto& [a, b, c] = mesh.triangles[at(t)];
    if (!(doubled_area(mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)]) < 0.0)) continue;
    std::swap(b, c);
    if (++count == 1) first = t;
  }
  if (count == 0 || count == mesh.num_triangles()) return {};
  return {"turned " + std::to_string(count) + " of " + std::to_string(mesh.num_triangles()) +
          " triangles, which are clockwise, others not; the first is triangle " + number_text(mesh, first)};
}

/// The components in the plane of one value.
void append_plane_value(const MshField& field, std::size_t i, std::vector<double>& values) {
  const double* v = field.values.data() + i * static_cast<std::size_t>(field.components);
  const auto refuse = [&field, i](const char* problem) {
    throw InputError("field '" + field.name + "' at tag " + std::to_string(field.tags[i]) + ": " + problem);
  };
  if (field.components == 1) {
    values.push_back(v[0]);
  } else if (field.components == 3) {
    if (v[2] != 0.0) refuse("the vector leaves the plane");
    values.insert(values.end(), {v[0], v[1]});
  } else {
    if (v[1] != v[3]) refuse("the tensor is not symmetric");
    if (v[2] != 0.0 || v[5] != 0.0 || v[6] != 0.0 || v[7] != 0.0 || v[8] != 0.0) refuse("the tensor leaves the plane");
    values.insert(values.end(), {v[0], v[1], v[4]});
  }
}

/// Our entities of one kind, and what messages call one of them.
struct Entities {
  const char* name;
  const std::vector<std::int64_t>& tags;  // of each
};

/// A field with one value for each of our entities. Nothing, and a note, where it has values on a part of them only.
std::optional<MeshField> plane_field(const MshField& field, const Entities& entities, std::vector<std::string>& notes) {
  TagMap places;
  for (const std::int64_t tag : field.tags) places.add(tag);
  if (!places.finish()) throw InputError("field '" + field.name + "' has two values at one tag");
  MeshField result{field.name, field.components == 1 ? 1 : (field.components == 3 ? 2 : 3), {}};
  for (const std::int64_t tag : entities.tags) {
    const int place = places.index(tag);
    if (place < 0) {
      notes.push_back("field '" + field.name + "' is left out: it has no value at " + entities.name + " " +
                      std::to_string(tag));
      return std::nullopt;
    }
    append_plane_value(field, at(place), result.values);
  }
  return result;
}

/// Of fields of one name, which are time steps, the last one is taken.
std::vector<MeshField> plane_fields(const std::vector<MshField>& fields, const Entities& entities,
                                    std::vector<std::string>& notes) {
  std::vector<MeshField> result;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool has_later_step = std::any_of(fields.begin() + static_cast<std::ptrdiff_t>(i) + 1, fields.end(),
                                            [&](const MshField& later) { return later.name == fields[i].name; });
    if (has_later_step) continue;
    if (std::optional<MeshField> field = plane_field(fields[i], entities, notes)) result.push_back(std::move(*field));
  }
  return result;
}

/// Takes out the fields that mark what is required to stay: those of that name that consist of 0 and 1.
std::vector<MshField> take_marks(std::vector<MshField>& fields) {
  const auto is_field = [](const MshField& field) {
    return field.name != kRequiredField || field.components != 1 ||
           !std::all_of(field.values.begin(), field.values.end(), [](double v) { return v == 0.0 || v == 1.0; });
  };
  const auto first = std::stable_partition(fields.begin(), fields.end(), is_field);
  std::vector<MshField> marks(std::make_move_iterator(first), std::make_move_iterator(fields.end()));
  fields.erase(first, fields.end());
  return marks;
}

/// Those of our entities whose tags are marked; tag_of: the tag of each.
std::vector<int> marked(const std::vector<MshField>& marks, const std::vector<std::int64_t>& tag_of) {
  std::set<std::int64_t> tags;
  for (const MshField& field : marks)
    for (std::size_t i = 0; i < field.tags.size(); ++i)
      if (field.values[i] == 1.0) tags.insert(field.tags[i]);
  std::vector<int> result;
  for (std::size_t i = 0; i < tag_of.size(); ++i)
    if (tags.contains(tag_of[i])) result.push_back(static_cast<int>(i));
  return result;
}

}  // namespace

MeshData mesh_data_of(MshContent content) {
  sort_by_tag(content.lines);
  sort_by_tag(content.triangles);
  drop_repeated(content.lines);
  drop_repeated(content.triangles);
  MeshData data;
  Mesh& mesh = data.mesh;
  mesh.first_number = 1;
  mesh.labels = labels_of(content.lines.groups, 1, content, mesh.label_names);
  mesh.regions = labels_of(content.triangles.groups, 2, content, mesh.region_names);
  mesh.edges = std::move(content.lines.nodes);
  mesh.triangles = std::move(content.triangles.nodes);
  if (mesh.edges.empty() && mesh.triangles.empty()) throw InputError("has neither lines nor triangles");
  const std::vector<int> used = take_used_nodes(content, mesh);
  data.mesh_notes = turn_clockwise_triangles(mesh);
  if (!mesh.triangles.empty()) cover_boundary(mesh);
  std::vector<std::int64_t> node_tags;
  node_tags.reserve(used.size());
  for (const int node : used) node_tags.push_back(content.node_tags.tag(node));
  mesh.required.vertices = marked(take_marks(content.node_fields), node_tags);
  const std::vector<MshField> marks = take_marks(content.element_fields);
  mesh.required.edges = marked(marks, content.lines.tags);
  mesh.required.triangles = marked(marks, content.triangles.tags);
  data.fields.points = plane_fields(content.node_fields, {"node", node_tags}, data.notes);
  data.fields.cells = plane_fields(content.element_fields, {"triangle", content.triangles.tags}, data.notes);
  return data;
}

}  // namespace parmesan
