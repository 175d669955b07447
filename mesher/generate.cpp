#include "mesher/generate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "mesher/cracks.h"
#include "mesher/curve_vertices.h"
#include "mesher/errors.h"
#include "mesher/geometry/chord_limits.h"
#include "mesher/geometry/clean.h"
#include "mesher/geometry/outline.h"
#include "mesher/metric/complexity.h"
#include "mesher/outside_parts.h"
#include "mesher/particles/curve_chords.h"
#include "mesher/particles/error_descent.h"
#include "mesher/particles/fast_schedule.h"
#include "mesher/particles/overlooked.h"
#include "mesher/particles/previous_mesh.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/ordering.h"
#include "mesher/triangulation/refine.h"
#include "mesher/triangulation/triangulate.h"
#include "mesher/user_labels.h"
#include "mesher/validate.h"

namespace parmesan {
namespace {

constexpr double coarsest_vertices = 200.0;

// Levels above the last, each with a quarter of the vertices of the next.
int coarser_levels(double expected) {
  return std::max(0, static_cast<int>(std::lround(std::log(expected / coarsest_vertices) / std::log(4.0))));
}

double scale_of(int level) { return std::pow(0.25, level); }

// While a mesh is made, its edges are labelled with the segment they are a part of.
std::vector<int> segment_numbers(const Domain& domain) {
  std::vector<int> numbers(domain.segments.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

// Directed edges are numbered 4q + r in 32 bits, and a mesh has three times as many edges as vertices.
constexpr std::int64_t most_vertices = (std::int64_t{1} << 29) / 3;

void check_size(double expected, std::int64_t max_vertices) {
  max_vertices = std::min(max_vertices, most_vertices);
  if (expected <= static_cast<double>(max_vertices)) return;
  const bool is_countable = expected < 1e18;
  throw LimitError("the metric asks for " +
                   (is_countable ? "about " + std::to_string(std::llround(expected)) : "more than 10^18") +
                   " vertices; the limit is " + std::to_string(max_vertices));
}

FastScheduleOptions effort_of(const GenerateOptions& options) {
  FastScheduleOptions effort{.further_rounds = 12};  // good
  if (options.preset == Preset::Mid)
    effort = {.rounds = 2, .sweeps_per_round = 1, .final_force_sweeps = 4, .final_apex_sweeps = 2};
  if (options.preset == Preset::Fast)
    effort = {.rounds = 2, .sweeps_per_round = 1, .final_force_sweeps = 2, .final_apex_sweeps = 1};
  effort.max_vertices = options.max_vertices;
  effort.particles = options.particles;
  effort.momentum = options.particles.momentum.value_or(effort.momentum);
  return effort;
}

/// A mesh, its edges labelled with segments, and what its particles feel.
struct Relaxed {
  Mesh mesh;
  std::vector<Metric> metrics;
  std::optional<Mesh> before_descent;  // the mesh as it was before its error was lowered
};

Relaxed taken_from(const ParticleSystem& particles) {
  ConvertedMesh converted = to_mesh(particles.mesh(), segment_numbers(particles.domain()));
  Relaxed relaxed{.mesh = std::move(converted.mesh), .metrics = {}, .before_descent = {}};
  relaxed.metrics.reserve(converted.slots.size());
  for (const VertexId v : converted.slots) relaxed.metrics.push_back(particles.metric(v));
  return relaxed;
}

// The last stage, where there is a function whose error can be lowered.
Relaxed taken_lower_in_error(ParticleSystem& particles, const TensorField* hessian) {
  if (hessian == nullptr) return taken_from(particles);
  Mesh before = taken_from(particles).mesh;
  lower_error(particles, *hessian);
  split_distant_chords(particles);
  Relaxed relaxed = taken_from(particles);
  relaxed.before_descent = std::move(before);
  return relaxed;
}

// Particles are swept in the order of memory.
Mesh in_local_order(Mesh mesh) {
  if (is_local(mesh)) return mesh;
  return reordered(mesh, local_order(mesh));
}

Mesh refined(const Mesh& mesh, const Domain& domain) { return refine_red(mesh, middles_on_curves(mesh, domain)); }

/// The mesh of the domain's sites, with more of them where these do not show what the metric asks for.
struct ScratchStart {
  Mesh mesh;
  OverlookedParts overlooked;
  double held;  // complexity of the field's samples
  double expected_vertices;
};

ScratchStart scratch_start(const Domain& domain, Mesh mesh, const MetricField& field, std::int64_t max_vertices) {
  constexpr double much_more = 1.1;
  mesh.required = required_parts(mesh, domain);
  OverlookedParts overlooked(field, domain);
  const double seen = integrate_complexity(mesh, field), held = overlooked.complexity_within(mesh);
  const double expected = expected_vertices(std::max(seen, held));
  check_size(expected, max_vertices);
  if (held > much_more * seen) mesh = overlooked.with_sites(mesh, scale_of(coarser_levels(expected)));
  return {std::move(mesh), overlooked, held, expected};
}

// Coarsest level: the isotropic part of the metric, so that bisection of long edges makes no
// slivers; then each level takes the refined mesh of the one before and relaxes it in the metric.
// Coarse levels are relaxed even where their population is right: what is out of order there stays so when
// it is refined (uniform, 200 000 vertices: mean quality .985, .978 without, at the same cost). The coarsest has the
// most rounds, as refinement keeps its density and they cost nothing there. Without momentum: it pays when a later
// remesh settles what it has stirred up.
Relaxed mesh_in_levels(const Domain& domain, const MetricField& field, const ScratchStart& start,
                       FastScheduleOptions effort, const GenerateOptions& options) {
  constexpr std::int64_t coarse_limit = 1'000'000;  // for memory: isotropic meshes may have more vertices on segments
  effort.momentum = options.particles.momentum.value_or(0.0);
  const int levels = coarser_levels(start.expected_vertices);
  const FastScheduleOptions coarse_effort{.rounds = 2,
                                          .sweeps_per_round = 2,
                                          .final_force_sweeps = 0,
                                          .final_apex_sweeps = 0,
                                          .repairs = 0,
                                          .may_be_settled = levels == 0,
                                          .momentum = effort.momentum,
                                          .particles = effort.particles,
                                          .max_vertices = std::max(effort.max_vertices, coarse_limit)};
  FastScheduleOptions coarsest_effort = coarse_effort;
  coarsest_effort.rounds = 8;
  Relaxed relaxed{.mesh = start.mesh, .metrics = {}, .before_descent = {}};
  for (int level = levels; level >= 0; --level) {
    const double scale = scale_of(level);
    if (level == 1 && level < levels) relaxed.mesh = start.overlooked.with_sites(relaxed.mesh, scale);
    ParticleSystem particles(from_mesh(relaxed.mesh, relaxed.mesh.labels), domain, field, {scale, level == levels});
    relaxed = {};  // for its memory
    if (level == levels) {
      run_fast_schedule(particles, coarse_effort);
      particles.set_level({scale, false});
    }
    run_fast_schedule(particles, level == 0 ? effort : level == levels ? coarsest_effort : coarse_effort);
    if (options.observer) options.observer(particles, levels - level);
    relaxed = level == 0 ? taken_lower_in_error(particles, options.hessian) : taken_from(particles);
    if (level == 0) break;
    relaxed.mesh.required = required_parts(relaxed.mesh, domain);
    relaxed.mesh = in_local_order(refined(relaxed.mesh, domain));
  }
  return relaxed;
}

// A spot that no particle came to see is not in the mesh: once more, with sites.
Relaxed mesh_from_scratch(const Domain& domain, const MetricField& field, ScratchStart start,
                          const FastScheduleOptions& effort, const GenerateOptions& options) {
  constexpr double most = 0.7;
  Relaxed relaxed = mesh_in_levels(domain, field, start, effort, options);
  const double by_metric = integrate_complexity(relaxed.mesh, relaxed.metrics);  // large if one vertex sees the spot
  const double by_vertices = relaxed.mesh.num_vertices() / expected_vertices(1.0);
  if (std::min(by_metric, by_vertices) >= most * start.held) return relaxed;
  const std::size_t num_sites = start.mesh.points.size();
  start.mesh = start.overlooked.with_sites(start.mesh, scale_of(coarser_levels(start.expected_vertices)), 0.0);
  return start.mesh.points.size() == num_sites ? relaxed : mesh_in_levels(domain, field, start, effort, options);
}

Relaxed mesh_from_previous(const Domain& domain, const MetricField& field, Mesh mesh, const FastScheduleOptions& effort,
                           const GenerateOptions& options) {
  ParticleSystem particles(from_mesh(mesh, mesh.labels), domain, field);
  mesh = {};  // for its memory
  if (options.observer) options.observer(particles, 0);
  run_fast_schedule(particles, effort);
  return taken_lower_in_error(particles, options.hessian);
}

Mesh refined_start(Mesh mesh, const Domain& domain, int times) {
  mesh.required = required_parts(mesh, domain);
  for (int i = 0; i < times; ++i) mesh = refined(mesh, domain);
  return mesh;
}

// From the sites of the domain, or from the previous mesh as it is.
Relaxed mesh_by_thesis(const Domain& domain, const MetricField& field, const Mesh& start,
                       const GenerateOptions& options, GenerateReport& report) {
  ParticleSystem particles(from_mesh(start, start.labels), domain, field);
  report.thesis =
      run_thesis_schedule(particles, options.particles, options.seed, options.max_vertices, options.observer);
  split_distant_chords(particles);
  if (!report.thesis->settled) report.warnings.push_back(report.thesis->diagnosis);
  return taken_lower_in_error(particles, options.hessian);
}

// The particles of a crack are those of both its sides.
std::optional<Mesh> fitted_to_curves(Mesh mesh, const Domain& domain, const Mesh& sites) {
  std::optional<Mesh> fit = fitted(has_cracks(mesh) ? close_cracks(mesh).mesh : std::move(mesh), domain, sites);
  return fit ? put_on_curves(*std::move(fit), domain) : std::nullopt;
}

// Both sides of a crack have the metric of the particles on it.
std::vector<Metric> metrics_of(const OpenedMesh& opened, const std::vector<Metric>& metrics) {
  std::vector<Metric> result;
  result.reserve(opened.sources.size());
  for (const int v : opened.sources) result.push_back(metrics[static_cast<std::size_t>(v)]);
  return result;
}

}  // namespace

GenerateResult generate(const Domain& user_domain, const MetricField& field, const GenerateOptions& options,
                        std::optional<Mesh> previous) {
  GenerateResult result;
  if (!(options.chord_error > 0.0)) throw InputError("the chord error must be above 0");
  CleanDomain cleaned = clean(user_domain);
  Domain& domain = cleaned.domain;
  const Outline outline = outline_of(domain);
  limit_chord_errors(domain, outline, options.chord_error);
  result.report.warnings = std::move(cleaned.repairs);
  const FastScheduleOptions effort = effort_of(options);
  const bool by_thesis = options.schedule == Schedule::Thesis;
  validate(options.particles);

  Mesh sites = to_mesh(triangulate(outline.domain), outline.segments).mesh;
  if (std::optional<std::string> outside = outside_parts(sites, domain))
    result.report.warnings.push_back(*std::move(outside));

  StartChoice choice{.reason = "there is no previous mesh"};
  std::optional<Mesh> fit;
  if (previous) {
    fit = fitted_to_curves(*std::move(previous), domain, sites);
    choice = fit ? choose_start(*fit, field) : StartChoice{.reason = "the previous mesh does not fit the geometry"};
    if (fit && by_thesis)
      choice = {Start::PreviousMesh, 0, choice.expected_vertices, "the thesis's schedule starts from any mesh"};
    if (!fit) result.report.warnings.push_back(choice.reason + ": started from scratch");
  }
  Relaxed relaxed;
  if (choice.start == Start::Scratch) {
    ScratchStart start = scratch_start(domain, std::move(sites), field, options.max_vertices);
    relaxed = by_thesis ? mesh_by_thesis(domain, field, start.mesh, options, result.report)
                        : mesh_from_scratch(domain, field, std::move(start), effort, options);
  } else {
    check_size(choice.expected_vertices, options.max_vertices);
    Mesh start = refined_start(std::move(*fit), domain, choice.refinements);
    relaxed = by_thesis ? mesh_by_thesis(domain, field, start, options, result.report)
                        : mesh_from_previous(domain, field, in_local_order(std::move(start)), effort, options);
  }
  result.report.start = choice.start;
  result.report.start_reason = std::move(choice.reason);
  result.report.diagnosis = diagnose(relaxed.mesh, relaxed.metrics, domain);
  if (std::optional<std::string> chords = distant_chords(relaxed.mesh, domain))
    result.report.warnings.push_back(std::move(*chords));
  OpenedMesh opened = with_user_labels(std::move(relaxed.mesh), domain);
  result.metrics = metrics_of(opened, relaxed.metrics);
  result.mesh = std::move(opened.mesh);
  if (relaxed.before_descent) result.relaxed = with_user_labels(std::move(*relaxed.before_descent), domain).mesh;
  result.report.complexity = integrate_complexity(result.mesh, result.metrics);
  validate(result.mesh);
  require_no_crossings(result.mesh, domain);
  return result;
}

}  // namespace parmesan
