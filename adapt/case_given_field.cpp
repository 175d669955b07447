#include <algorithm>
#include <cmath>

#include "adapt/case_file_geometry.h"
#include "adapt/case_reading.h"
#include "adapt/given_field.h"
#include "adapt/nearest_name.h"
#include "mesher/io/medit_fields.h"
#include "mesher/io/mesh_file.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

const std::string kPointer = "/problem/interpolate";

bool ends_with_sol(const std::string& path) { return path.ends_with(".sol") || path.ends_with(".solb"); }

/// The scalars at vertices, and notes on what else there was.
MeshData scalars_at_vertices(const std::string& path) {
  MeshData data = ends_with_sol(path) ? MeshData{{}, read_medit_fields(path)} : read_mesh_data(path);
  std::erase_if(data.fields.points, [](const MeshField& field) { return field.components != 1; });
  return data;
}

/// The field of that name, or the only one. Nothing, and an issue, where it is not clear which is meant.
std::optional<MeshField> choose(CaseReading& reading, MeshData data, const std::string& name) {
  std::vector<MeshField>& fields = data.fields.points;
  std::vector<std::string> names;
  names.reserve(fields.size());
  for (const MeshField& field : fields) names.push_back(field.name);
  if (name.empty() && fields.size() == 1) return std::move(fields.front());
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return std::move(fields[static_cast<std::size_t>(found - names.begin())]);
  if (names.empty()) {
    std::string problem = "the file has no scalar field at vertices";
    for (const std::string& note : data.notes) problem += "; " + note;
    reading.issues.add(kPointer + "/file", problem);
  } else {
    reading.issues.add(kPointer + "/field", (name.empty() ? "must name one of several fields"
                                                          : "there is no field '" + name.substr(0, 60) + "'") +
                                                suggestion(name, names) + ". Those in the file: " + quoted_list(names));
  }
  return std::nullopt;
}

}  // namespace

std::shared_ptr<const GivenField> read_given_field(CaseReading& reading) {
  const nlohmann::ordered_json& section = reading.document.root["problem"]["interpolate"];
  const auto mesh = named_file(reading, section["mesh"].get<std::string>(), kPointer + "/mesh");
  const auto file = named_file(reading, section["file"].get<std::string>(), kPointer + "/file");
  if (!mesh || !file) return nullptr;
  std::optional<MeshField> field = choose(reading, scalars_at_vertices(*file), section.value("field", std::string()));
  if (!field) return nullptr;
  auto given = std::make_shared<GivenField>();
  given->mesh = read_valid_mesh(*mesh);
  given->values = std::move(field->values);
  if (given->mesh.triangles.empty()) {
    reading.issues.add(kPointer + "/mesh", "the mesh has no triangles");
    return nullptr;
  }
  if (given->values.size() != given->mesh.points.size()) {
    reading.issues.add(kPointer + "/file", "has " + std::to_string(given->values.size()) + " values; the mesh has " +
                                               std::to_string(given->mesh.points.size()) + " vertices");
    return nullptr;
  }
  for (std::size_t v = 0; v < given->values.size(); ++v) {
    if (std::isfinite(given->values[v])) continue;
    reading.issues.add(kPointer + "/file",
                       "the value at vertex " + std::to_string(v + 1) + " is " + text(given->values[v]));
    return nullptr;
  }
  return given;
}

}  // namespace parmesan
