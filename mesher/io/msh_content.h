#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesher/io/mesh_fields.h"
#include "mesher/io/tag_map.h"

namespace parmesan {

/// The groups of an element: 0 where it has none.
struct MshGroup {
  int physical = 0;
  int entity = 0;
};

/// The elements of one kind with N nodes, in the order of the file.
template <std::size_t N>
struct MshElements {
  std::vector<std::int64_t> tags;
  std::vector<std::array<int, N>> nodes;  // indices
  std::vector<MshGroup> groups;
};

/// A field as it stands in the file: values by tags.
struct MshField {
  std::string name;
  int components = 1;              // 1, 3 or 9
  std::vector<std::int64_t> tags;  // of nodes or elements
  std::vector<double> values;      // components x tags
};

/// What the sections of a Gmsh file hold, in Gmsh's numbers.
struct MshContent {
  TagMap node_tags;
  std::vector<std::array<double, 3>> nodes;
  MshElements<1> points;
  MshElements<2> lines;
  MshElements<3> triangles;
  std::map<std::pair<int, int>, std::string> physical_names;  // by dimension and number
  std::vector<MshField> node_fields;
  std::vector<MshField> element_fields;
};

/// The mesh and the fields in our numbers; see read_msh. Errors: InputError for what cannot be used, without a place.
MeshData mesh_data_of(MshContent content);

}  // namespace parmesan
