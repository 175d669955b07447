#include "mesher/generate.h"

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
#include "mesher/particles/fast_schedule.h"
#include "mesher/particles/overlooked.h"
#include "mesher/particles/previous_mesh.h"
#include "mesher/relaxed_mesh.h"
#include "mesher/scratch_mesh.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "mesher/user_labels.h"
#include "mesher/validate.h"
#include "mesher/vertex_limit.h"

namespace parmesan {
namespace {

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

Relaxed mesh_from_previous(const Domain& domain, const MetricField& field, Mesh mesh, const Relaxation& relaxation) {
  ParticleSystem particles(from_mesh(mesh, mesh.labels), domain, field);
  mesh = {};  // for its memory
  if (relaxation.observer) relaxation.observer(particles, 0);
  run_fast_schedule(particles, relaxation.effort);
  return taken_lower_in_error(particles, relaxation.hessian);
}

// With sites where the field holds a few vertices more than those of the mesh tell of: samples may lie as near to one
// another as its vertices do.
Mesh overlooking_nothing(Mesh mesh, const Domain& domain, const MetricField& field) {
  constexpr double of_four_vertices = 0.25;
  return OverlookedParts(field, domain).with_sites(std::move(mesh), of_four_vertices);
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

/// The previous mesh, where there is one and it fits the domain, and how to start.
struct Beginning {
  StartChoice choice;
  std::optional<Mesh> fit;
};

Beginning choose_beginning(Mesh previous, const Domain& domain, const Mesh& sites, const MetricField& field,
                           Schedule schedule) {
  std::optional<Mesh> fit = fitted_to_curves(std::move(previous), domain, sites);
  if (!fit) return {{.reason = "the previous mesh does not fit the geometry"}, {}};
  StartChoice choice = choose_start(*fit, field);
  if (schedule == Schedule::Thesis)
    choice = {Start::PreviousMesh, 0, choice.expected_vertices, "the thesis's schedule starts from any mesh"};
  return {std::move(choice), std::move(fit)};
}

/// What the user gets of the mesh, cracks opened and with the domain's labels.
GenerateResult finished(Relaxed relaxed, const Domain& domain, GenerateReport report) {
  GenerateResult result{.mesh = {}, .metrics = {}, .relaxed = {}, .report = std::move(report)};
  result.report.diagnosis = diagnose(relaxed.mesh, relaxed.metrics, domain);
  if (std::optional<std::string> chords = distant_chords(relaxed.mesh, domain))
    result.report.warnings.push_back(*std::move(chords));
  OpenedMesh opened = with_user_labels(std::move(relaxed.mesh), domain);
  result.metrics = opened.spread<Metric>(relaxed.metrics);
  result.mesh = std::move(opened.mesh);
  if (relaxed.before_descent) result.relaxed = with_user_labels(std::move(*relaxed.before_descent), domain).mesh;
  result.report.complexity = integrate_complexity(result.mesh, result.metrics);
  validate(result.mesh);
  require_no_crossings(result.mesh, domain);
  return result;
}

}  // namespace

GenerateResult generate(const Domain& user_domain, const MetricField& field, const GenerateOptions& options,
                        std::optional<Mesh> previous) {
  if (!(options.chord_error > 0.0)) throw InputError("the chord error must be above 0");
  CleanDomain cleaned = clean(user_domain);
  Domain& domain = cleaned.domain;
  const Outline outline = outline_of(domain);
  limit_chord_errors(domain, outline, options.chord_error);
  validate(options.particles);
  GenerateReport report;
  report.warnings = std::move(cleaned.repairs);

  Mesh sites = to_mesh(triangulate(outline.domain), outline.segments).mesh;
  require_within_limit(sites, options.max_vertices);
  if (std::optional<std::string> outside = outside_parts(sites, domain)) report.warnings.push_back(*std::move(outside));
  Beginning start{{.reason = "there is no previous mesh"}, {}};
  if (previous) {
    start = choose_beginning(*std::move(previous), domain, sites, field, options.schedule);
    if (!start.fit) report.warnings.push_back(start.choice.reason + ": started from scratch");
  }
  report.start = start.choice.start;
  report.start_reason = start.choice.reason;

  const bool by_thesis = options.schedule == Schedule::Thesis;
  const Relaxation relaxation{effort_of(options), options.hessian, options.observer};
  Relaxed relaxed;
  if (start.choice.start == Start::Scratch) {
    ScratchStart scratch = scratch_start(domain, std::move(sites), field, options.max_vertices);
    relaxed = by_thesis ? mesh_by_thesis(domain, field, scratch.mesh, options, report)
                        : mesh_from_scratch(domain, field, std::move(scratch), relaxation);
  } else {
    require_few_vertices(start.choice.expected_vertices, options.max_vertices);
    Mesh mesh = overlooking_nothing(refined(*std::move(start.fit), domain, start.choice.refinements), domain, field);
    relaxed = by_thesis ? mesh_by_thesis(domain, field, mesh, options, report)
                        : mesh_from_previous(domain, field, in_local_order(std::move(mesh)), relaxation);
  }
  require_within_limit(relaxed.mesh, options.max_vertices);
  return finished(std::move(relaxed), domain, std::move(report));
}

}  // namespace parmesan
