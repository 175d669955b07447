#pragma once

#include <optional>
#include <string>

#include "adapt/case_reading.h"
#include "adapt/domain_builder.h"

namespace parmesan {

/// Reads { "center", "axes", "rotation" }: a closed curve, or the part of it from "from" to "to". Degrees.
Curve read_ellipse(const nlohmann::ordered_json& value);

/// Reads { "center", "radius" } as a closed curve.
Curve read_circle(const nlohmann::ordered_json& value);

/// Reads one of "arc", "ellipse", "spline", "through" and "parametric" of an object; nothing, and an issue, when it is
/// no curve.
std::optional<Curve> read_curve(CaseReading& reading, const nlohmann::ordered_json& object, const std::string& pointer);

/// Reads a list of pieces, lines and curves, each of which begins where the one before ends, the first where the last
/// ends. Nothing, and issues, when they do not. label: of pieces without.
std::optional<Path> read_closed_path(CaseReading& reading, const nlohmann::ordered_json& pieces,
                                     const std::string& pointer, const std::string& label);

}  // namespace parmesan
