#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// A named field at the vertices or the triangles of a mesh.
struct MeshField {
  std::string name;
  int components = 1;          // 1 scalar, 2 vector x y, 3 symmetric tensor xx xy yy
  std::vector<double> values;  // components x number of vertices or triangles, one entity after the other
};

/// The fields of a mesh.
struct MeshFields {
  std::vector<MeshField> points;  // at vertices
  std::vector<MeshField> cells;   // one value per triangle

  bool empty() const { return points.empty() && cells.empty(); }
};

/// A mesh with its fields.
struct MeshData {
  Mesh mesh;
  MeshFields fields;
  std::vector<std::string> notes = {};       // what was left out of the fields, or is doubtful, one sentence each
  std::vector<std::string> mesh_notes = {};  // what was changed in the mesh, one sentence each
};

/// What files whose format has no section for required parts call the field that marks them, by 1 among 0.
inline constexpr const char* kRequiredField = "required";

/// One number for each of n entities: 1 for those in the list, 0 for the others.
std::vector<unsigned char> required_marks(const std::vector<int>& required, std::size_t n);

/// Throws InputError unless each field has 1 to 3 components and one value per entity.
void check_fields(const MeshFields& fields, const Mesh& mesh);

/// A field of symmetric tensors.
MeshField tensor_field(const std::string& name, std::span<const Metric> metrics);

/// The number of components of a field in space, where others' files have it: 1, 3 or 9.
int components_in_space(const MeshField& field);

/// The values in space: vectors x y 0, tensors by the rows of a 3 x 3 one with zeros.
std::vector<double> values_in_space(const MeshField& field);

}  // namespace parmesan
