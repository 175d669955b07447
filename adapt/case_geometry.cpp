#include <algorithm>
#include <array>

#include "adapt/case_curves.h"
#include "adapt/case_file_geometry.h"
#include "adapt/case_reading.h"
#include "adapt/domain_builder.h"
#include "adapt/json_text.h"
#include "adapt/nearest_name.h"
#include "adapt/shapes.h"
#include "mesher/generate_around.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

const std::string kGeometry = "/geometry";

Point read_point(const Json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

Ring read_ring(const Json& value) {
  Ring ring;
  for (const Json& point : value) ring.push_back(read_point(point));
  return ring;
}

/// With "points" a regular polygon stands for the circle.
Ring read_disc_polygon(const Json& value) {
  return regular_polygon(read_point(value["center"]), value["radius"].get<double>(), value["points"].get<int>());
}

PathPiece closed(Curve curve, const std::string& label) { return {curve.at(0.0), curve.at(0.0), label, curve}; }

void add_disc(const Json& value, const std::string& label, DomainBuilder& builder) {
  if (value.contains("points")) return builder.add_ring(read_disc_polygon(value), {label});
  builder.add_path({closed(read_circle(value), label)});
}

/// The corners of {"min", "max"}; an issue when they are not in this order.
std::optional<Ring> read_box(CaseReading& reading, const Json& value, const std::string& pointer) {
  const Point min = read_point(value["min"]);
  const Point max = read_point(value["max"]);
  if (min.x < max.x && min.y < max.y) return rectangle(min, max);
  reading.issues.add(pointer, "'min' must be smaller than 'max' in both coordinates");
  return std::nullopt;
}

std::vector<std::string> box_sides() { return {"bottom", "right", "top", "left"}; }

std::optional<std::array<int, 4>> naca_digits(const std::string& code) {
  std::array<int, 4> digits{};
  if (code.size() != digits.size()) return std::nullopt;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (code[i] < '0' || code[i] > '9') return std::nullopt;
    digits[i] = code[i] - '0';
  }
  const bool camber_has_place = digits[0] == 0 || digits[1] != 0;
  if (!camber_has_place || (digits[2] == 0 && digits[3] == 0)) return std::nullopt;
  return digits;
}

void add_naca(CaseReading& reading, const Json& value, DomainBuilder& builder) {
  const std::string pointer = kGeometry + "/naca";
  const std::optional<Ring> channel = read_box(reading, value["channel"], pointer + "/channel");
  const std::optional<std::array<int, 4>> digits = naca_digits(value["code"].get<std::string>());
  if (!digits) reading.issues.add(pointer + "/code", "must be four digits with a thickness, such as '0012' or '2412'");
  if (!digits || !channel) return;
  const AirfoilPlacement placement{value["chord"].get<double>(), value["angle"].get<double>(),
                                   read_point(value["position"])};
  const Ring airfoil = naca_airfoil(*digits, value["points"].get<int>(), placement);
  const Point min = channel->front();
  const Point max = (*channel)[2];
  const bool fits = std::all_of(airfoil.begin(), airfoil.end(), [&min, &max](const Point& p) {
    return p.x > min.x && p.x < max.x && p.y > min.y && p.y < max.y;
  });
  if (!fits) reading.issues.add(pointer + "/channel", "the airfoil must lie inside the channel");
  builder.add_ring(*channel, box_sides());
  builder.add_hole(airfoil, "airfoil");
}

void add_polygon(CaseReading& reading, const Json& geometry, DomainBuilder& builder) {
  const Ring ring = read_ring(geometry["polygon"]);
  std::vector<std::string> sides{"boundary"};
  if (geometry.contains("labels") && geometry["labels"].is_array()) {
    sides = geometry["labels"].get<std::vector<std::string>>();
    if (sides.size() != ring.size()) {
      reading.issues.add(kGeometry + "/labels", "must name each of the " + std::to_string(ring.size()) +
                                                    " sides of the polygon, not " + std::to_string(sides.size()));
      sides = {"boundary"};
    }
  }
  builder.add_ring(ring, sides);
}

/// kept: the mesh of a file.
void add_outline(CaseReading& reading, const Json& geometry, DomainBuilder& builder, std::optional<Mesh>& kept) {
  if (geometry.contains("rectangle")) {
    const std::optional<Ring> box = read_box(reading, geometry["rectangle"], kGeometry + "/rectangle");
    if (box) builder.add_ring(*box, box_sides());
  }
  if (geometry.contains("disc")) add_disc(geometry["disc"], "circle", builder);
  if (geometry.contains("ellipse")) builder.add_path({closed(read_ellipse(geometry["ellipse"]), "ellipse")});
  if (geometry.contains("curves")) {
    const std::optional<Path> path = read_closed_path(reading, geometry["curves"], kGeometry + "/curves", "boundary");
    if (path) builder.add_path(*path);
  }
  if (geometry.contains("polygon")) add_polygon(reading, geometry, builder);
  if (geometry.contains("naca")) add_naca(reading, geometry["naca"], builder);
  if (!geometry.contains("file")) return;
  std::optional<GeometryInput> file =
      read_named_geometry(reading, geometry["file"].get<std::string>(), kGeometry + "/file");
  if (!file) return;
  builder = DomainBuilder(std::move(file->domain));
  kept = std::move(file->mesh);
}

/// The numbers of the regions that are to stay, which must be known by name.
std::vector<int> read_required_regions(CaseReading& reading, const Json& geometry, const Domain& domain) {
  std::vector<int> regions;
  std::vector<std::string> names;
  for (const RegionSeed& seed : domain.regions) names.push_back(label_name(domain.region_names, seed.region));
  const Json wanted = geometry.value("required", Json::array());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::string name = wanted[i].get<std::string>();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) {
      regions.push_back(domain.regions[static_cast<std::size_t>(found - names.begin())].region);
      continue;
    }
    const std::string hint = suggestion(name, names);
    reading.issues.add(kGeometry + "/required/" + std::to_string(i), "there is no region '" + name.substr(0, 60) + "'" +
                                                                         (hint.empty() ? "." : hint) +
                                                                         " The regions are: " + quoted_list(names));
  }
  return regions;
}

void add_hole(CaseReading& reading, const Json& hole, const std::string& label, const std::string& pointer,
              DomainBuilder& builder) {
  if (hole.contains("polygon")) return builder.add_hole(read_ring(hole["polygon"]), label);
  if (hole.contains("ellipse")) return builder.add_hole({closed(read_ellipse(hole["ellipse"]), label)});
  if (hole.contains("disc") && hole["disc"].contains("points"))
    return builder.add_hole(read_disc_polygon(hole["disc"]), label);
  if (hole.contains("disc")) return builder.add_hole({closed(read_circle(hole["disc"]), label)});
  const std::optional<Path> path = read_closed_path(reading, hole["curves"], pointer + "/curves", label);
  if (path) builder.add_hole(*path);
}

void add_holes(CaseReading& reading, const Json& holes, DomainBuilder& builder) {
  int number = 0;
  for (const Json& hole : holes) {
    const std::string pointer = kGeometry + "/holes/" + std::to_string(number);
    const std::string name = "hole" + std::to_string(++number);
    if (hole.is_array()) {
      builder.add_hole(read_ring(hole), name);
    } else {
      add_hole(reading, hole, hole.value("label", name), pointer, builder);
    }
  }
}

/// "labels": {"old": "new"}.
void rename_sides(CaseReading& reading, const Json& names, DomainBuilder& builder) {
  const std::string pointer = kGeometry + "/labels";
  const std::vector<int> labels = builder.labels_in_use();
  std::vector<std::string> present;
  present.reserve(labels.size());
  for (const int label : labels) present.push_back(label_name(builder.domain().label_names, label));
  for (const auto& [old_name, new_name] : names.items()) {
    if (old_name.starts_with("x-")) continue;
    const auto found = std::find(present.begin(), present.end(), old_name);
    if (found != present.end()) {
      builder.rename(labels[static_cast<std::size_t>(found - present.begin())], new_name.get<std::string>());
      continue;
    }
    const std::string hint = suggestion(old_name, present);
    reading.issues.add(pointer + pointer_step(old_name), "there is no side '" + old_name.substr(0, 60) + "'" +
                                                             (hint.empty() ? "." : hint) +
                                                             " The sides are: " + quoted_list(present));
  }
}

void read_labels(CaseReading& reading, const Json& geometry, DomainBuilder& builder) {
  if (!geometry.contains("labels")) return;
  if (geometry["labels"].is_object()) return rename_sides(reading, geometry["labels"], builder);
  if (geometry.contains("polygon")) return;
  reading.issues.add(kGeometry + "/labels", "a list of names is for polygons; write { \"side\": \"new name\" }");
}

void add_inner_segment(CaseReading& reading, const Json& segment, const std::string& pointer, DomainBuilder& builder) {
  const std::string label = segment["label"].get<std::string>();
  std::optional<std::string> right;
  if (segment.contains("label_right")) right = segment["label_right"].get<std::string>();
  const bool is_required = segment.value("required", false);
  if (!segment.contains("from")) {
    const std::optional<Curve> curve = read_curve(reading, segment, pointer);
    if (curve) builder.add_curve(*curve, label, right, is_required);
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
  for (const char* key : {"holes", "points", "segments", "regions"}) {
    if (geometry.contains(key))
      reading.issues.add(kGeometry + "/" + key, "cannot be added to a mesh with triangles that are required to stay");
  }
  mesh.label_names = read.domain.label_names;
  mesh.region_names = read.domain.region_names;
  return mesh;
}

}  // namespace

std::optional<CaseGeometry> read_geometry_section(CaseReading& reading) {
  if (!reading.document.root.contains("geometry") || !reading.issues.clean(kGeometry)) return std::nullopt;
  const Json& geometry = reading.document.root["geometry"];
  DomainBuilder builder;
  std::optional<Mesh> file_mesh;
  add_outline(reading, geometry, builder, file_mesh);
  if (!reading.issues.clean(kGeometry)) return std::nullopt;
  add_holes(reading, geometry.value("holes", Json::array()), builder);
  read_labels(reading, geometry, builder);
  CaseGeometry result;
  const std::vector<int> outline = builder.labels_in_use();
  add_insides(reading, geometry, builder);
  const bool from_file = geometry.contains("file");
  result.cracks = builder.crack_labels();
  for (const int label : builder.labels_in_use()) {
    const bool is_side = std::ranges::binary_search(outline, label) || std::ranges::binary_search(result.cracks, label);
    (is_side && !from_file ? result.sides : result.optional).push_back(label);
  }
  result.domain = builder.domain();
  result.required_regions = read_required_regions(reading, geometry, result.domain);
  if (file_mesh) result.kept = mesh_to_keep(reading, geometry, std::move(*file_mesh), result);
  if (!reading.issues.clean(kGeometry)) return std::nullopt;
  return result;
}

}  // namespace parmesan
