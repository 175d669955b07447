#include "adapt/compare.h"

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "adapt/adapt_loop.h"
#include "adapt/measure.h"
#include "adapt/number_text.h"
#include "adapt/outputs.h"
#include "adapt/report/report.h"
#include "adapt/stopwatch.h"
#include "adapt/targets.h"
#include "mesher/arc_heights.h"
#include "mesher/errors.h"
#include "mesher/io/output_file.h"
#include "mesher/triangulation/refine.h"

namespace parmesan {
namespace {

CompareRow row_of(MeshFamily family, const IterationRow& measured, const Iterate& iterate, double cpu_seconds) {
  CompareRow row;
  row.family = family;
  row.vertices = measured.vertices;
  row.triangles = measured.triangles;
  row.efficiency = measured.efficiency;
  row.cpu_seconds = cpu_seconds;
  if (measured.goal) {
    row.goal_value = measured.goal->value;
    row.goal_estimate = measured.goal->estimate.error;
    row.goal_error = measured.goal->error;
  }
  if (measured.solution_error) {
    row.solution_l2 = measured.solution_error->l2;
    row.solution_h1 = measured.solution_error->h1;
  }
  if (measured.interpolation_error) {
    row.interpolation_l2 = measured.interpolation_error->l2;
    row.interpolation_h1 = measured.interpolation_error->h1;
  }
  if (measured.estimated_error) {
    row.estimated_l2 = measured.estimated_error->l2;
    row.estimated_h1 = measured.estimated_error->h1;
  }
  row.at_round_off = is_round_off(row.leading_l2(), iterate.mesh, iterate.values);
  return row;
}

// The case as a comparison runs it: to a given size, whatever its own targets are.
Case aimed_at(const Case& input, std::int64_t vertices) {
  Case aimed = input;
  aimed.targets = {};
  aimed.targets.vertices = vertices;
  aimed.initial_vertices = std::min(input.initial_vertices, vertices);
  return aimed;
}

double spent(const std::vector<IterationRow>& rows) {
  double cpu = 0.0;
  for (const IterationRow& row : rows) cpu += row.seconds.cpu;
  return cpu;
}

/// The state of a comparison; compare_case() runs it.
class Comparison {
 public:
  Comparison(const Case& input, const CompareOptions& options) : case_(input), options_(options) {
    case_.mesher.max_vertices = options.max_vertices;
    result_.case_name = input.name;
  }

  CompareResult run() {
    adapted(MeshFamily::Anisotropic);
    adapted(MeshFamily::Isotropic);
    uniform();
    for (const MeshFamily family : mesh_families) fit(family);
    find_equivalents();
    result_.interrupted = interrupted();
    result_.table = compare_table(result_);
    return std::move(result_);
  }

 private:
  bool interrupted() const { return options_.interrupted && options_.interrupted->load(); }

  void add(const CompareRow& row) {
    const std::string line = std::string(to_string(row.family)) + padded(std::to_string(row.vertices), 9) +
                             " vertices  L2 " + short_number(row.leading_l2(), 4) + "  " +
                             short_number(row.cpu_seconds, 3) + " s";
    result_.rows.push_back(row);
    const std::size_t expected = mesh_families.size() * options_.sizes.size();
    const double share = static_cast<double>(result_.rows.size()) / static_cast<double>(expected);
    if (options_.progress) options_.progress({line, std::min(1.0, share)});
  }

  // From size to size, each started from the last mesh of the one before.
  void adapted(MeshFamily family) {
    LoopOptions loop;
    loop.max_vertices = options_.max_vertices;
    loop.interrupted = options_.interrupted;
    loop.isotropic = family == MeshFamily::Isotropic;
    loop.aims = &case_.targets;
    LoopStart start{.limit = limit_};
    Iterate last;
    double cpu = 0.0;
    for (const std::int64_t size : options_.sizes) {
      if (interrupted()) return;
      LoopResult run = adapt(aimed_at(case_, size), loop, start);
      if (interrupted()) return;
      limit_ = start.limit = run.limit;
      cpu += spent(run.summary.iterations);
      last = std::move(run.last);
      start.first = &last;
      add(row_of(family, run.summary.iterations.back(), last, cpu));
    }
  }

  // The given sizes, then red refinement until the best adapted error is reached.
  void uniform() {
    double best = std::numeric_limits<double>::infinity();
    for (const CompareRow& row : result_.rows) best = std::min(best, row.leading_l2());
    Iterate last;
    for (const std::int64_t size : options_.sizes) {
      if (interrupted()) return;
      Iterate next = uniform_iterate(case_, static_cast<double>(size));
      add_uniform(next, last);
    }
    constexpr double margin = 1.1;
    const double largest = std::min(margin * static_cast<double>(options_.max_uniform_vertices),
                                    static_cast<double>(options_.max_vertices));
    const auto is_worse = [this, best] {
      return !result_.rows.back().at_round_off && result_.rows.back().leading_l2() > best;
    };
    while (!interrupted() && is_worse() && 4.0 * last.mesh.num_vertices() <= largest) {
      const Stopwatch watch;
      Iterate next;
      next.mesh = refine_red(last.mesh, middles_of_arcs(last.mesh, case_.domain));
      next.metrics.assign(next.mesh.points.size(), last.metrics.front().scaled(4.0));
      next.complexity = 4.0 * last.complexity;
      next.seconds.cpu = watch.cpu_seconds();
      add_uniform(next, last);
    }
  }

  void add_uniform(Iterate& next, Iterate& last) {
    compute_values(case_, next, last.values.empty() ? nullptr : &last);
    const IterationRow measured = measure(case_, next, 0, limit_);
    add(row_of(MeshFamily::Uniform, measured, next, measured.seconds.cpu));
    last = std::move(next);
  }

  void fit(MeshFamily family) {
    std::vector<double> sizes, l2, h1;
    for (const CompareRow& row : result_.rows) {
      if (row.family != family || row.at_round_off) continue;
      sizes.push_back(static_cast<double>(row.vertices));
      l2.push_back(row.leading_l2());
      h1.push_back(row.leading_h1());
    }
    result_.l2_orders.push_back(fit_order(sizes, l2));
    result_.h1_orders.push_back(fit_order(sizes, h1));
  }

  void find_equivalents() {
    std::vector<double> sizes, seconds, errors;
    for (const CompareRow& row : result_.rows) {
      if (row.family != MeshFamily::Uniform || row.at_round_off) continue;
      sizes.push_back(static_cast<double>(row.vertices));
      seconds.push_back(row.cpu_seconds);
      errors.push_back(row.leading_l2());
    }
    if (sizes.empty()) return;
    for (const CompareRow& row : result_.rows) {
      if (row.family == MeshFamily::Uniform || row.at_round_off) continue;
      const double l2 = row.leading_l2();
      result_.equivalents.push_back({row.family, row.vertices, row.cpu_seconds, l2, size_for_error(sizes, errors, l2),
                                     size_for_error(seconds, errors, l2)});
    }
  }

  Case case_;
  const CompareOptions& options_;
  std::optional<InterpolationLimit> limit_;
  CompareResult result_;
};

void check_sizes(const std::vector<std::int64_t>& sizes, std::int64_t max_vertices) {
  constexpr std::int64_t smallest = 10;
  if (sizes.empty()) throw InputError("a comparison needs at least one size");
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (sizes[k] < smallest || (k > 0 && sizes[k] <= sizes[k - 1]))
      throw InputError("sizes must be ascending and at least 10 vertices, not " + std::to_string(sizes[k]));
  }
  Targets largest;
  largest.vertices = sizes.back();
  require_within_limit(largest, max_vertices);
}

}  // namespace

double CompareRow::leading_l2() const {
  constexpr double absent = std::numeric_limits<double>::quiet_NaN();
  return solution_l2 ? *solution_l2 : interpolation_l2 ? *interpolation_l2 : estimated_l2.value_or(absent);
}

double CompareRow::leading_h1() const {
  constexpr double absent = std::numeric_limits<double>::quiet_NaN();
  return solution_h1 ? *solution_h1 : interpolation_h1 ? *interpolation_h1 : estimated_h1.value_or(absent);
}

CompareResult compare_case(const Case& input, const CompareOptions& options) {
  check_sizes(options.sizes, options.max_vertices);
  const std::string folder = options.out_dir.empty() ? input.name + ".compare" : options.out_dir;
  const EarlierFiles earlier = options.overwrite ? EarlierFiles::Replace : EarlierFiles::Refuse;
  const FolderLock lock = prepare_folder(folder, earlier);
  CompareResult result = Comparison(input, options).run();
  if (result.rows.empty()) return result;
  result.out_dir = folder;
  remove_earlier_files(folder, earlier);
  write_file(folder + "/case.json", input.resolved.dump(2) + "\n");
  write_file(folder + "/compare.csv", compare_csv(result));
  write_file(folder + "/summary.json", to_json(result).dump(2) + "\n", true);
  write_report(folder + "/report.html", {folder});
  return result;
}

}  // namespace parmesan
