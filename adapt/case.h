#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adapt/case_error.h"
#include "adapt/expression.h"
#include "adapt/given_field.h"
#include "adapt/io/any_geometry.h"
#include "adapt/metric_options.h"
#include "adapt/targets.h"
#include "fem/problem.h"
#include "mesher/generate.h"

namespace parmesan {

/// A number made of the solution that is reported with every iteration.
struct CaseFunctional {
  enum class Kind { Integral, BoundaryIntegral, Flux, Value };
  std::string name;
  Kind kind = Kind::Integral;
  std::string where;                 // name of a region or a label, "*" for the whole domain
  std::optional<Expression> weight;  // of integrals
  Point point;                       // of a value
  std::optional<double> exact;       // its value for the exact solution, where the case knows it
};

/// Pass limit on a field of the last iteration in summary.json.
struct Expectation {
  std::vector<std::string> path;  // names from there: {"efficiency"}, {"solution_error", "l2"}; or {"targets_met"}
  std::optional<double> min, max;
  std::optional<bool> equals;
};

struct OutputOptions {
  std::vector<std::string> formats{"vtu", "mesh", "svg"};
};

/// A case file, read, checked and compiled; everything the loop needs.
struct Case {
  std::string name;
  std::string title;
  nlohmann::ordered_json resolved;  // as run, every default filled in
  std::vector<std::string> files;   // that it names, and those that are read along with them
  Domain domain;
  std::vector<int> required_regions;        // whose triangles stay as the file, or the first mesh, has them
  std::optional<Mesh> kept;                 // the mesh of the geometry's file, where that has required triangles
  bool interpolation = false;               // "interpolate": adapt to a given function, no PDE
  std::optional<Expression> exact;          // exact solution, or the function to interpolate
  std::shared_ptr<const GivenField> given;  // in place of exact: the function to interpolate, from a file
  Problem problem;                          // empty when interpolation
  std::vector<CaseFunctional> functionals;
  std::optional<CaseFunctional> goal;  // the functional that meshes are made for, with its error estimated
  MetricOptions metric;
  Targets targets;
  GenerateOptions mesher;
  bool lower_error = false;  // meshes are changed to lower the L2 error itself ("mesher": {"lower_error": ...})
  std::int64_t initial_vertices = 400;  // size of the uniform start mesh ("initial": {"vertices": ...})
  double continuation = 1.0;            // factor on the diffusion to begin with ("initial": {"continuation": ...})
  OutputOptions output;
  std::vector<Expectation> expect;
};

/// Reads a case file. Errors: FileError (cannot be read), CaseError (all issues at once),
/// GeometryError (the geometry it describes or names is invalid, and nothing else is).
Case read_case(const std::string& path, const std::vector<Override>& overrides = {});

/// The same from text; file is used in messages and to find files the case names.
Case parse_case(const std::string& text, const std::string& file, const std::vector<Override>& overrides = {});

/// What a case file, or a JSON file that has only the "geometry", and "parameters", of a case, describes: the domain as
/// it is written, not cleaned, and the mesh that has the triangles it requires. Nothing when the file is not of this
/// kind: JSON with the key "geometry" and without GeoJSON's "type". merge_tolerance: takes the place of the case's,
/// unless 0. Errors: as read_case.
std::optional<GeometryInput> read_case_geometry(const std::string& path, double merge_tolerance = 0.0);

}  // namespace parmesan
