#include <algorithm>

#include "adapt/case.h"
#include "adapt/case_curves.h"
#include "adapt/case_reading.h"
#include "adapt/case_shapes.h"
#include "adapt/domain_builder.h"
#include "adapt/region_names.h"
#include "mesher/base_faces.h"
#include "mesher/generate_around.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

const std::string kGeometry = "/geometry";

/// The numbers of the regions that are to stay, which must be known by name.
std::vector<int> read_required_regions(CaseReading& reading, const Json& geometry, const Domain& domain) {
  const auto wanted = geometry.value("required", Json::array()).get<std::vector<std::string>>();
  return regions_named(wanted, regions_by_name(domain), [&reading](std::size_t i, const std::string& problem) {
    reading.issues.add(kGeometry + "/required/" + std::to_string(i), problem);
  });
}

void add_inner_segment(CaseReading& reading, const Json& segment, const std::string& pointer, DomainBuilder& builder) {
  const std::string label = segment["label"].get<std::string>();
  std::optional<std::string> right;
  if (segment.contains("label_right")) right = segment["label_right"].get<std::string>();
  const bool is_required = segment.value("required", false);
  if (!segment.contains("from")) {
    if (is_required) reading.issues.add(pointer + "/required", "is for straight segments: no edge runs along a curve");
    const std::optional<Curve> curve = read_curve(reading, segment, pointer);
    if (curve) builder.add_curve(*curve, label, right);
  } else if (segment.contains("to")) {
    builder.add_segment(read_point(segment["from"]), read_point(segment["to"]), label, right, is_required);
  } else {
    reading.issues.add(pointer, "the key 'to' is missing");
  }
}

void add_insides(CaseReading& reading, const Json& geometry, DomainBuilder& builder) {
  // Domains of meshes around required regions keep those points that are required.
  const bool has_required_regions = geometry.contains("required");
  for (const Json& point : geometry.value("points", Json::array()))
    builder.add_point(read_point(point), has_required_regions);
  int number = 0;
  for (const Json& segment : geometry.value("segments", Json::array()))
    add_inner_segment(reading, segment, kGeometry + "/segments/" + std::to_string(number++), builder);
  const Json regions = geometry.value("regions", Json::object());
  for (const auto& [name, seed] : regions.items()) {
    if (!name.starts_with("x-")) builder.add_region(name, read_point(seed));
  }
}

/// The mesh of a file where it has triangles that are to stay; then nothing can be added to it.
std::optional<Mesh> mesh_to_keep(CaseReading& reading, const Json& geometry, Mesh mesh, const CaseGeometry& read) {
  mesh = with_required_regions(std::move(mesh), read.required_regions);
  if (mesh.required.triangles.empty()) return std::nullopt;
  for (const char* key : {"holes", "points", "segments", "regions", "merge_tolerance"}) {
    if (geometry.contains(key))
      reading.issues.add(kGeometry + "/" + key, "is not for a mesh with triangles that are required to stay");
  }
  mesh.label_names = read.domain.label_names;
  mesh.region_names = read.domain.region_names;
  return mesh;
}

/// What is a shape need not be a geometry: an airfoil needs its channel, and nothing can be done with nothing.
bool is_usable_alone(CaseReading& reading, const Json& geometry, const Shape& shape) {
  if (geometry.contains("naca") && !geometry["naca"].contains("channel"))
    reading.issues.add(kGeometry + "/naca", "the key 'channel' is missing; only shapes of operations do without");
  for (const char* operation : {"union", "intersection", "difference"}) {
    if (geometry.contains(operation) && shape.builder.domain().segments.empty())
      reading.issues.add(kGeometry + "/" + operation, "leaves nothing: the result has no area");
  }
  return reading.issues.clean(kGeometry);
}

bool has_additions(const Domain& domain, const DomainBase& base) {
  return domain.segments.size() > base.segments || domain.points.size() > base.points;
}

/// Whether what was added to a base may part what its seeds stand for.
bool may_move_seeds(const Domain& domain, const DomainBase& base) {
  return has_additions(domain, base) && (domain.inside == Inside::EvenOdd || base.holes > 0 || base.regions > 0);
}

}  // namespace

std::optional<CaseGeometry> read_geometry_section(CaseReading& reading) {
  if (!reading.document.root.contains("geometry") || !reading.issues.clean(kGeometry)) return std::nullopt;
  const Json& geometry = reading.document.root["geometry"];
  std::optional<Shape> shape = read_shape(reading, geometry, kGeometry);
  if (!shape || !is_usable_alone(reading, geometry, *shape)) return std::nullopt;
  DomainBuilder& builder = shape->builder;
  CaseGeometry result;
  const std::vector<int> outline = builder.labels_in_use();
  const DomainBase base = base_of(builder.domain());
  add_insides(reading, geometry, builder);
  result.cracks = builder.crack_labels();
  for (const int label : builder.labels_in_use()) {
    const bool is_side = std::ranges::binary_search(outline, label) || std::ranges::binary_search(result.cracks, label);
    (is_side && !shape->is_from_file ? result.sides : result.optional).push_back(label);
  }
  result.domain = builder.domain();
  if (!shape->is_from_file || has_additions(result.domain, base))  // files are read with it
    result.domain.merge_tolerance = merge_tolerance_of(reading, kGeometry);
  if (may_move_seeds(result.domain, base)) result.domain = with_parts_kept(std::move(result.domain), base);
  result.required_regions = read_required_regions(reading, geometry, result.domain);
  if (shape->mesh) result.kept = mesh_to_keep(reading, geometry, std::move(*shape->mesh), result);
  if (!reading.issues.clean(kGeometry)) return std::nullopt;
  return result;
}

}  // namespace parmesan
