#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adapt/clipped_sizes.h"
#include "adapt/goal_error.h"
#include "adapt/stop_reason.h"
#include "adapt/stopwatch.h"
#include "fem/estimators.h"
#include "fem/norms.h"
#include "fem/solve.h"
#include "mesher/diagnosis.h"
#include "mesher/geometry/point.h"
#include "mesher/quality.h"
#include "mesher/start_choice.h"

namespace parmesan {

/// Where the triangle of the lowest quality lies. Units: L.
struct WorstElement {
  Point center;
  double quality = 0.0;
};

/// The functional that meshes are made for.
struct GoalRow {
  double value = 0.0;           // J(u_h)
  GoalError estimate;           // of J(u) - J(u_h)
  std::optional<double> error;  // J(u) - J(u_h), where J(u) is known

  /// With what the estimate says added: Pierce & Giles, SIAM Rev. 42 (2000) 247.
  double corrected() const { return value + estimate.error; }
  std::optional<double> corrected_error() const { return error ? std::optional(*error - estimate.error) : error; }
};

/// One row of the report: a mesh, what it is worth and what it cost. Absent values are null.
struct IterationRow {
  int iteration = 0;
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  double complexity = 0.0;  // integral of sqrt(det M) of the metric asked for
  ClippedSizes clipped;     // by the limits of that metric
  std::optional<ErrorNorms> interpolation_error;
  std::optional<double> efficiency;
  std::optional<ErrorNorms> solution_error;
  std::optional<EstimatedError> estimated_error;
  std::optional<double> residual_h1;          // as the residuals of the equation say (fem/residual_estimate.h)
  std::optional<GoalRow> goal;                // absent without a goal
  std::optional<SolveReport> solve_report;    // absent for interpolation
  std::map<std::string, double> fluxes;       // out through the sides of each label
  std::map<std::string, double> functionals;  // those the case asks for
  double unit_edges = 0.0;
  double length_min = 0.0, length_max = 0.0;
  double quality_min = 0.0, quality_p01 = 0.0, quality_mean = 0.0, quality_min_away_from_corners = 0.0;
  WorstElement worst;
  Diagnosis diagnosis;
  Start start = Start::Scratch;
  std::string start_reason;
  StageSeconds seconds;
  double peak_memory_mb = 0.0;
};

/// A pass limit of the case and what the run gave.
struct Verdict {
  std::string name;
  bool passed = false;
  std::string message;  // e.g. "efficiency = 1.23, max 1.1"
};

/// What a run was and what came of it: the content of summary.json.
struct Summary {
  std::string case_name;
  std::uint64_t seed = 1;
  int threads = 1;
  StopReason stop_reason = StopReason::MaxIterations;
  bool error_targets_declared = false;
  bool targets_met = false;
  std::optional<double> interpolation_limit;  // N_T ||u - I_h u||_L2 of the best meshes
  std::vector<std::string> warnings;
  std::vector<IterationRow> iterations;
};

/// Copies the statistics of a mesh in its metric into a row.
void set_quality(IterationRow& row, const Mesh& mesh, const MeshQuality& quality);

/// One row as summary.json has it.
nlohmann::ordered_json to_json(const IterationRow& row);

/// summary.json. Numbers that are not finite become null.
nlohmann::ordered_json to_json(const Summary& summary);

}  // namespace parmesan
