#include "adapt/case_curves.h"

#include <algorithm>
#include <numbers>

#include "mesher/geometry/arcs.h"
#include "mesher/geometry/cubic_spline.h"
#include "mesher/geometry/spline.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

double radians(const Json& degrees) { return degrees.get<double>() * std::numbers::pi / 180.0; }

Curve read_arc(const Json& value) {
  return circular_arc(read_point(value["center"]), value["radius"].get<double>(), radians(value["from"]),
                      radians(value["to"]));
}

std::optional<Curve> read_spline(CaseReading& reading, const Json& value, const std::string& pointer) {
  Spline spline{.control = {}, .degree = value["degree"].get<int>(), .knots = {}, .weights = {}};
  for (const Json& point : value["points"]) spline.control.push_back(read_point(point));
  if (value.contains("knots")) spline.knots = value["knots"].get<std::vector<double>>();
  if (value.contains("weights")) spline.weights = value["weights"].get<std::vector<double>>();
  if (const auto fault = fault_of(spline)) {
    reading.issues.add(pointer + "/" + fault->member, fault->problem);
    return std::nullopt;
  }
  return spline_curve(std::move(spline));
}

std::optional<Curve> read_through(CaseReading& reading, const Json& value, const std::string& pointer) {
  std::vector<Point> points;
  for (const Json& point : value["points"]) points.push_back(read_point(point));
  const SplineEnds ends = value["closed"].get<bool>() ? SplineEnds::Periodic : SplineEnds::Natural;
  if (const auto fault = fault_of_points(points, ends)) {
    reading.issues.add(pointer + "/points", *fault);
    return std::nullopt;
  }
  return cubic_spline(std::move(points), ends);
}

/// A number or an expression of t, which stands at the place of x in it.
std::optional<Expression> read_coordinate(CaseReading& reading, const Json& value, const std::string& pointer) {
  if (value.is_number()) return Expression::constant(value.get<double>());
  try {
    return Expression::parse(value.get<std::string>(), reading.parameters, {}, {"t"});
  } catch (const ExpressionError& error) {
    reading.issues.add(pointer, error.what(), error.position());
    return std::nullopt;
  }
}

std::optional<Curve> read_parametric(CaseReading& reading, const Json& value, const std::string& pointer) {
  const std::optional<Expression> x = read_coordinate(reading, value["x"], pointer + "/x");
  const std::optional<Expression> y = read_coordinate(reading, value["y"], pointer + "/y");
  if (!x || !y) return std::nullopt;
  const auto point = [u = *x, v = *y](double t) { return Point{u.value({t, 0.0}), v.value({t, 0.0})}; };
  const auto derivative = [u = *x, v = *y](double t) { return Vector{u.jet({t, 0.0}).x, v.jet({t, 0.0}).x}; };
  return Curve(point, derivative, value["from"].get<double>(), value["to"].get<double>());
}

std::optional<Curve> read_kind(CaseReading& reading, const Json& object, const std::string& kind,
                               const std::string& pointer) {
  if (kind == "arc") return read_arc(object[kind]);
  if (kind == "ellipse") return read_ellipse(object[kind]);
  if (kind == "spline") return read_spline(reading, object[kind], pointer);
  if (kind == "through") return read_through(reading, object[kind], pointer);
  return read_parametric(reading, object[kind], pointer);
}

/// Adds the pieces of one entry of the list.
void read_piece(CaseReading& reading, const Json& piece, const std::string& pointer, const std::string& label,
                Path& path) {
  if (!piece.contains("line")) {
    std::optional<Curve> curve = read_curve(reading, piece, pointer);
    if (curve) path.push_back({curve->at(0.0), curve->at(1.0), label, std::move(curve)});
    return;
  }
  const Json& line = piece["line"];
  for (std::size_t i = 1; i < line.size(); ++i)
    path.push_back({read_point(line[i - 1]), read_point(line[i]), label, std::nullopt});
}

bool meet(const PathPiece& a, const PathPiece& b) {
  constexpr double tolerance = 1e-9;
  const double size = std::max(norm(a.end - a.begin), a.curve ? a.curve->extent() : 0.0) +
                      std::max(norm(b.end - b.begin), b.curve ? b.curve->extent() : 0.0);
  return norm(b.begin - a.end) <= tolerance * size;
}

}  // namespace

Curve read_ellipse(const Json& value) {
  return ellipse_arc(read_point(value["center"]), read_point(value["axes"]), radians(value["rotation"]),
                     radians(value.value("from", Json(0))), radians(value.value("to", Json(360))));
}

Curve read_circle(const Json& value) {
  return circular_arc(read_point(value["center"]), value["radius"].get<double>(), 0.0, 2.0 * std::numbers::pi);
}

std::optional<Curve> read_curve(CaseReading& reading, const Json& object, const std::string& pointer) {
  for (const std::string kind : {"arc", "ellipse", "spline", "through", "parametric"}) {
    if (!object.contains(kind)) continue;
    std::string place = pointer;
    place.append("/").append(kind);
    try {
      return read_kind(reading, object, kind, place);
    } catch (const GeometryError& error) {
      reading.issues.add(place, error.what());
    }
  }
  return std::nullopt;
}

std::optional<Path> read_closed_path(CaseReading& reading, const Json& pieces, const std::string& pointer,
                                     const std::string& label) {
  Path path;
  std::vector<std::size_t> first;  // piece of the path that each entry begins with
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    first.push_back(path.size());
    read_piece(reading, pieces[i], pointer + "/" + std::to_string(i), pieces[i].value("label", label), path);
  }
  if (!reading.issues.clean(pointer)) return std::nullopt;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const PathPiece& piece = path[first[i]];
    const PathPiece& before = path[(first[i] + path.size() - 1) % path.size()];
    if (meet(before, piece)) continue;
    reading.issues.add(
        pointer + "/" + std::to_string(i),
        "begins at " + text(piece.begin, 12) + ", but the piece before " + "it ends at " + text(before.end, 12));
  }
  return reading.issues.clean(pointer) ? std::optional(std::move(path)) : std::nullopt;
}

}  // namespace parmesan
