#include "adapt/case_shapes.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "adapt/case_curves.h"
#include "adapt/case_file_geometry.h"
#include "adapt/hole_placement.h"
#include "adapt/json_text.h"
#include "adapt/nearest_name.h"
#include "adapt/shapes.h"
#include "mesher/errors.h"
#include "mesher/geometry/clean.h"
#include "mesher/set_operation.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

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

/// Without a channel the airfoil itself; with "points" a polygon stands for it.
void add_naca(CaseReading& reading, const Json& value, const std::string& pointer, DomainBuilder& builder) {
  const std::optional<NacaSection> section = naca_section(value["code"].get<std::string>());
  if (!section)
    return reading.issues.add(pointer + "/code",
                              "must be four digits with a thickness, such as '0012' or '2412', or five, of the series "
                              "210 to 250, such as '23012'");
  const AirfoilPlacement placement{value["chord"].get<double>(), value["angle"].get<double>(),
                                   read_point(value["position"])};
  const bool is_polygon = value.contains("points");
  const Ring ring = is_polygon ? naca_airfoil(*section, value["points"].get<int>(), placement) : Ring();
  const Path path = is_polygon ? Path() : Path{closed(naca_curve(*section, placement), "airfoil")};
  if (!value.contains("channel")) return is_polygon ? builder.add_ring(ring, {"airfoil"}) : builder.add_path(path);
  const std::optional<Ring> channel = read_box(reading, value["channel"], pointer + "/channel");
  if (!channel) return;
  const Point min = channel->front();
  const Point max = (*channel)[2];
  const Ring around = is_polygon ? ring : path.front().curve->sample_points();
  const bool fits = std::all_of(around.begin(), around.end(), [&min, &max](const Point& p) {
    return p.x > min.x && p.x < max.x && p.y > min.y && p.y < max.y;
  });
  if (!fits) reading.issues.add(pointer + "/channel", "the airfoil must lie inside the channel");
  builder.add_ring(*channel, box_sides());
  if (is_polygon) {
    builder.add_hole(ring, "airfoil");
  } else {
    builder.add_hole(path);
  }
}

void add_polygon(CaseReading& reading, const Json& geometry, const std::string& pointer, DomainBuilder& builder) {
  const Ring ring = read_ring(geometry["polygon"]);
  std::vector<std::string> sides{"boundary"};
  if (geometry.contains("labels") && geometry["labels"].is_array()) {
    sides = geometry["labels"].get<std::vector<std::string>>();
    if (sides.size() != ring.size()) {
      reading.issues.add(pointer + "/labels", "must name each of the " + std::to_string(ring.size()) +
                                                  " sides of the polygon, not " + std::to_string(sides.size()));
      sides = {"boundary"};
    }
  }
  builder.add_ring(ring, sides);
}

void add_file(CaseReading& reading, const Json& geometry, const std::string& pointer, Shape& shape) {
  std::optional<GeometryInput> file =
      read_named_geometry(reading, geometry["file"].get<std::string>(), pointer + "/file");
  if (!file) return;
  shape.builder = DomainBuilder(std::move(file->domain));
  shape.mesh = std::move(file->mesh);
  shape.is_from_file = true;
}

const std::map<std::string, SetOperation>& operations() {
  static const std::map<std::string, SetOperation> names{{"union", SetOperation::Union},
                                                         {"intersection", SetOperation::Intersection},
                                                         {"difference", SetOperation::Difference}};
  return names;
}

/// What work() returns; throws its errors with the pointer of the shape.
template <class Work>
auto naming_shape(const std::string& pointer, Work work) {
  try {
    return work();
  } catch (const GeometryError& error) {
    throw GeometryError(pointer + ": " + error.what(), error.indices());
  }
}

void require_valid(const Domain& domain, const std::string& pointer) {
  if (!domain.segments.empty()) naming_shape(pointer, [&domain] { return clean(domain); });
}

void add_operation(CaseReading& reading, const Json& shapes, SetOperation operation, const std::string& pointer,
                   Shape& result) {
  std::vector<Domain> domains;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string place = pointer + "/" + std::to_string(i);
    const std::optional<Shape> shape = read_shape(reading, shapes[i], place);
    if (!shape) continue;
    if (shape->mesh && !shape->mesh->required.triangles.empty())
      reading.issues.add(place + "/file", "has triangles that are required to stay, which no operation can do");
    require_valid(shape->builder.domain(), place);
    domains.push_back(result.builder.renumbered(shape->builder.domain()));
    result.is_from_file = result.is_from_file || shape->is_from_file;
  }
  if (!reading.issues.clean(pointer)) return;
  result.builder.replace(naming_shape(pointer, [&] { return combine(operation, domains); }));
}

void add_outline(CaseReading& reading, const Json& geometry, const std::string& pointer, Shape& shape) {
  DomainBuilder& builder = shape.builder;
  if (geometry.contains("rectangle")) {
    const std::optional<Ring> box = read_box(reading, geometry["rectangle"], pointer + "/rectangle");
    if (box) builder.add_ring(*box, box_sides());
  }
  if (geometry.contains("disc")) add_disc(geometry["disc"], "circle", builder);
  if (geometry.contains("ellipse")) builder.add_path({closed(read_ellipse(geometry["ellipse"]), "ellipse")});
  if (geometry.contains("curves")) {
    const std::optional<Path> path = read_closed_path(reading, geometry["curves"], pointer + "/curves", "boundary");
    if (path) builder.add_path(*path);
  }
  if (geometry.contains("polygon")) add_polygon(reading, geometry, pointer, builder);
  if (geometry.contains("naca")) add_naca(reading, geometry["naca"], pointer + "/naca", builder);
  if (geometry.contains("file")) add_file(reading, geometry, pointer, shape);
  for (const auto& [name, operation] : operations()) {
    if (!geometry.contains(name)) continue;
    const std::string place = std::string(pointer).append("/").append(name);
    add_operation(reading, geometry[name], operation, place, shape);
  }
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

void add_holes(CaseReading& reading, const Json& shape, const std::string& place, DomainBuilder& builder) {
  if (!shape.contains("holes")) return;
  const DomainBase base = base_of(builder.domain());
  int number = 0;
  std::vector<PlacedHole> placed;
  for (const Json& hole : shape["holes"]) {
    const std::string pointer = place + "/holes/" + std::to_string(number);
    const std::string name = "hole" + std::to_string(++number);
    const std::size_t first = builder.domain().segments.size();
    if (hole.is_array()) {
      builder.add_hole(read_ring(hole), name);
    } else {
      add_hole(reading, hole, hole.value("label", name), pointer, builder);
    }
    const std::size_t last = builder.domain().segments.size();
    if (last > first) placed.push_back({pointer, first, last});
  }
  Domain domain = builder.domain();
  domain.merge_tolerance = merge_tolerance_of(reading, place);
  HolePlacement placement = place_holes(std::move(domain), placed, base);
  for (const HoleFault& fault : placement.faults)
    reading.issues.add_geometry(placed[fault.hole].pointer, fault.message);
  builder.replace(std::move(placement.domain));
}

/// "labels": {"old": "new"}.
void rename_sides(CaseReading& reading, const Json& names, const std::string& pointer, DomainBuilder& builder) {
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

void read_labels(CaseReading& reading, const Json& geometry, const std::string& pointer, DomainBuilder& builder) {
  if (!geometry.contains("labels")) return;
  if (geometry["labels"].is_object()) return rename_sides(reading, geometry["labels"], pointer + "/labels", builder);
  if (geometry.contains("polygon")) return;
  reading.issues.add(pointer + "/labels", "a list of names is for polygons; write { \"side\": \"new name\" }");
}

}  // namespace

std::optional<Shape> read_shape(CaseReading& reading, const Json& shape, const std::string& pointer) {
  Shape result;
  add_outline(reading, shape, pointer, result);
  if (!reading.issues.clean(pointer)) return std::nullopt;
  add_holes(reading, shape, pointer, result.builder);
  read_labels(reading, shape, pointer, result.builder);
  if (!reading.issues.clean(pointer)) return std::nullopt;
  return result;
}

}  // namespace parmesan
