#include "mesher/io/mesh_fields.h"

#include "mesher/errors.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

void check_field(const MeshField& field, std::size_t entities, const char* where) {
  const bool fits = field.components >= 1 && field.components <= 3 &&
                    field.values.size() == entities * static_cast<std::size_t>(field.components);
  if (fits) return;
  throw InputError("field '" + field.name + "' has " + std::to_string(field.values.size()) + " values of " +
                   std::to_string(field.components) + " components, the mesh has " + std::to_string(entities) + " " +
                   where + "; components are 1 to 3");
}

}  // namespace

std::vector<unsigned char> required_marks(const std::vector<int>& required, std::size_t n) {
  std::vector<unsigned char> marks(n, 0);
  for (const int i : required) marks[at(i)] = 1;
  return marks;
}

void check_fields(const MeshFields& fields, const Mesh& mesh) {
  for (const MeshField& field : fields.points) check_field(field, mesh.points.size(), "vertices");
  for (const MeshField& field : fields.cells) check_field(field, mesh.triangles.size(), "triangles");
}

MeshField tensor_field(const std::string& name, std::span<const Metric> metrics) {
  MeshField field{name, 3, {}};
  field.values.reserve(3 * metrics.size());
  for (const Metric& metric : metrics) {
    const SymmetricTensor& m = metric.tensor();
    field.values.insert(field.values.end(), {m.xx, m.xy, m.yy});
  }
  return field;
}

int components_in_space(const MeshField& field) { return field.components == 1 ? 1 : (field.components == 2 ? 3 : 9); }

std::vector<double> values_in_space(const MeshField& field) {
  const std::vector<double>& v = field.values;
  if (field.components == 1) return v;
  std::vector<double> result;
  result.reserve(3 * v.size());
  if (field.components == 2) {
    for (std::size_t i = 0; i + 1 < v.size(); i += 2) result.insert(result.end(), {v[i], v[i + 1], 0.0});
  } else {
    for (std::size_t i = 0; i + 2 < v.size(); i += 3) {
      result.insert(result.end(), {v[i], v[i + 1], 0.0, v[i + 1], v[i + 2], 0.0, 0.0, 0.0, 0.0});
    }
  }
  return result;
}

}  // namespace parmesan
