#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adapt/case.h"
#include "adapt/equal_error.h"
#include "adapt/order_fit.h"
#include "adapt/progress.h"

namespace parmesan {

/// The families of meshes that are compared.
enum class MeshFamily { Anisotropic, Isotropic, Uniform };
inline constexpr std::array mesh_families{MeshFamily::Anisotropic, MeshFamily::Isotropic, MeshFamily::Uniform};

/// How a comparison is made.
struct CompareOptions {
  std::string out_dir;  // empty: the case's name + ".compare"
  bool overwrite = false;
  std::vector<std::int64_t> sizes{1000, 4000, 16000, 64000};  // vertices, ascending
  std::int64_t max_uniform_vertices = 1'000'000;              // the search for equal error ends at 1.1 times this
  std::int64_t max_vertices = 10'000'000;                     // safety limit, LimitError for sizes beyond
  ProgressListener progress;                                  // gets one line per mesh
  const std::atomic<bool>* interrupted = nullptr;
};

/// One mesh of one family. Absent values: no exact function, or no PDE.
struct CompareRow {
  MeshFamily family = MeshFamily::Anisotropic;
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  std::optional<double> solution_l2, solution_h1;
  std::optional<double> interpolation_l2, interpolation_h1;
  std::optional<double> estimated_l2, estimated_h1;
  std::optional<double> goal_value, goal_estimate, goal_error;  // as in GoalRow
  std::optional<double> efficiency;
  bool at_round_off = false;  // the leading L2 error says nothing: left out of orders and equal errors
  double cpu_seconds = 0.0;   // mesh, solve and recover, of all passes up to this mesh; not the measuring

  /// The error that is compared: of the solution, of the interpolant, or estimated, the first there is.
  double leading_l2() const;
  double leading_h1() const;
};

/// How many uniform vertices, and how much processor time for that mesh, reach the L2 error of one adapted mesh.
struct UniformEquivalent {
  MeshFamily family = MeshFamily::Anisotropic;
  std::int64_t vertices = 0;
  double cpu_seconds = 0.0;
  double l2 = 0.0;
  EqualError uniform;
  EqualError uniform_cpu_seconds;
};

/// The name of a family in tables and files: "anisotropic", "isotropic", "uniform".
std::string_view to_string(MeshFamily family);

/// Result of a comparison.
struct CompareResult {
  std::string case_name;
  std::vector<CompareRow> rows;
  std::vector<UniformEquivalent> equivalents;
  std::vector<OrderFit> l2_orders, h1_orders;  // one per MeshFamily, in its order
  bool interrupted = false;
  std::string table;    // for the terminal
  std::string out_dir;  // where compare.csv and summary.json are; empty where it was interrupted before the first mesh
};

/// The same case on anisotropic-adapted, isotropic-adapted and uniform meshes over a ladder of sizes.
///
/// What an earlier comparison left is replaced at the end, where there is a row: also by an interrupted one, then.
///
/// Errors: as run_case; InputError for sizes that are not ascending or below 10.
CompareResult compare_case(const Case& input, const CompareOptions& options);

/// The table for the terminal.
std::string compare_table(const CompareResult& result);

/// compare.csv: one line per mesh.
std::string compare_csv(const CompareResult& result);

/// summary.json of a comparison; numbers that are not finite or absent are null.
nlohmann::ordered_json to_json(const CompareResult& result);

}  // namespace parmesan
