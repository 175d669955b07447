#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adapt/expression.h"
#include "adapt/given_field.h"
#include "adapt/io/any_geometry.h"
#include "fem/problem.h"
#include "fem/recovery.h"
#include "mesher/generate.h"
#include "mesher/metric/background_mesh.h"

namespace parmesan {

/// The metric built from Hessians (adapt/README, "The metric, in this order").
enum class MetricKind { LoseilleAlauzet, SignAware };

struct MetricOptions {
  MetricKind kind = MetricKind::SignAware;
  double norm = 2.0;  // p of the Lp norm, infinity allowed
  Recovery recovery = Recovery::ZienkiewiczZhu;
  bool exact_hessian = false;  // "recovery": "exact", from the exact expression
  MetricInterpolation interpolation = MetricInterpolation::LogEuclidean;
  double h_min = 0.0;                            // smallest size, L; 0: none
  double h_max = 0.0;                            // largest size, L; 0: a quarter of the diagonal of the domain's box
  double max_aspect = 1e6;                       // largest ratio of the two sizes
  bool automatic_aspect = false;                 // "automatic": bounded where the solution asks for it (aspect_bound.h)
  double gradation = 0.0;                        // growth of size per unit metric length; 0: none
  std::optional<Expression> h_min_at, h_max_at;  // in place of the constants where sizes vary
};

/// What the loop tries to reach and when it gives up. Absent ones are not looked at.
struct Targets {
  std::optional<double> l2_error, h1_error, linf_error;
  std::optional<double> goal_error;          // of Case::goal
  std::optional<std::int64_t> vertices;      // aim at this size
  std::optional<std::int64_t> max_vertices;  // never ask for more
  int max_iterations = 20;
  std::optional<double> max_seconds;
};

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

/// One thing that is wrong with a case file.
struct CaseIssue {
  std::string pointer;  // JSON pointer
  int line = 0;         // 1-based, 0 when unknown
  int column = 0;
  std::string problem;  // what is wrong, what is allowed, the nearest right name
};

/// A case file cannot be used; what() lists every issue, one per line. Exit code 3.
class CaseError : public InputError {
 public:
  CaseError(const std::string& file, std::vector<CaseIssue> issues);
  const std::vector<CaseIssue>& issues() const { return issues_; }

 private:
  std::vector<CaseIssue> issues_;
};

/// A value that replaces or adds one in the case: --set /json/pointer=VALUE.
struct Override {
  std::string pointer;
  std::string value;  // JSON, or a plain string when it is not JSON
};

/// Reads a case file. Errors: FileError (cannot be read), CaseError (all issues at once),
/// GeometryError (the geometry it describes or names is invalid, and nothing else is).
Case read_case(const std::string& path, const std::vector<Override>& overrides = {});

/// The same from text; file is used in messages and to find files the case names.
Case parse_case(const std::string& text, const std::string& file, const std::vector<Override>& overrides = {});

/// What a case file, or a JSON file that has only the "geometry", and "parameters", of a case, describes: the domain as
/// it is written, not cleaned, and the mesh that has the triangles it requires. Nothing when the file is not of this
/// kind: JSON with the key "geometry" and without GeoJSON's "type". Errors: as read_case.
std::optional<GeometryInput> read_case_geometry(const std::string& path);

/// JSON Schema (draft 2020-12) of case files.
nlohmann::ordered_json case_schema();

}  // namespace parmesan
