#pragma once

#include <string>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// The entity, and physical group, that a Gmsh file is to have of one label or region, or of points.
struct MshEntity {
  int number = 0;            // Gmsh's, from 1
  std::string name;          // empty: none
  std::vector<int> members;  // edges, triangles or points
};

/// The entities of these labels, ascending; those of one name are one, those below 1 get the next free numbers.
std::vector<MshEntity> msh_entities_of(const std::vector<int>& labels, const LabelNames& names);

/// That of the points of a geometry that no line ends at, where there are any. Meshes have none that can be used.
std::vector<MshEntity> msh_entity_of_isolated_points(const Mesh& mesh);

}  // namespace parmesan
