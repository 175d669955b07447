#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "adapt/case_reading.h"
#include "adapt/domain_builder.h"

namespace parmesan {

/// A shape of a case: an outline with holes, or what a set operation makes of other shapes.
struct Shape {
  DomainBuilder builder;
  std::optional<Mesh> mesh;   // the mesh of a file
  bool is_from_file = false;  // or made of one that is
};

/// Reads the outline, the holes and the labels of /geometry or of a shape in it. What an operation leaves may be empty.
/// Nothing, and issues, when it cannot be used.
/// Errors: FileError, GeometryError from a geometry file; GeometryError that begins with the pointer of a shape.
std::optional<Shape> read_shape(CaseReading& reading, const nlohmann::ordered_json& shape, const std::string& pointer);

}  // namespace parmesan
