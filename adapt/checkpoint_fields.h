#pragma once

#include "adapt/loop_state.h"

namespace parmesan {

// What an archive needs to know of each struct; found by argument-dependent lookup. A field that is left out here
// is lost in a checkpoint: the test that resumes after each row sees to it.

template <class Archive>
void fields(Archive& archive, Point& p) {
  archive(p.x, p.y);
}

template <class Archive>
void fields(Archive& archive, Metric& m) {
  SymmetricTensor t = m.tensor();
  archive(t.xx, t.xy, t.yy);
  if constexpr (Archive::is_reader) m = Metric::from_tensor(t);
}

template <class Archive>
void fields(Archive& archive, Mesh& m) {
  archive(m.points, m.triangles, m.regions, m.edges, m.labels, m.label_names, m.region_names, m.required.vertices,
          m.required.edges, m.required.triangles);
}

template <class Archive>
void fields(Archive& archive, Misfits& m) {
  archive(m.reason, m.count, m.place, m.worst);
}

template <class Archive>
void fields(Archive& archive, Diagnosis& d) {
  archive(d.num_triangles, d.long_edges, d.short_edges, d.poor_triangles);
}

template <class Archive>
void fields(Archive& archive, GenerateReport& r) {
  archive(r.start, r.start_reason, r.complexity, r.diagnosis, r.warnings);
}

template <class Archive>
void fields(Archive& archive, StageSeconds& s) {
  archive(s.mesh, s.solve, s.recover, s.measure, s.cpu);
}

template <class Archive>
void fields(Archive& archive, Clipped& c) {
  archive(c.count, c.low, c.high);
}

template <class Archive>
void fields(Archive& archive, ClippedSizes& c) {
  archive(c.h_min, c.h_max, c.aspect, c.gradation);
}

template <class Archive>
void fields(Archive& archive, SolutionBounds& b) {
  archive(b.lower, b.upper);
}

template <class Archive>
void fields(Archive& archive, SolveReport& r) {
  archive(r.solver, r.unknowns, r.iterations, r.backward_error, r.peclet_min, r.peclet_max, r.capturing_steps,
          r.capturing_change, r.correction_steps, r.correction_change, r.correction_converges, r.null_components,
          r.compatibility_mismatch, r.minimum, r.maximum, r.bounds);
}

template <class Archive>
void fields(Archive& archive, Iterate& i) {
  archive(i.mesh, i.relaxed, i.metrics, i.values, i.residual, i.dual, i.complexity, i.clipped, i.report, i.solve_report,
          i.fluxes, i.estimated_error, i.goal_error, i.seconds);
}

template <class Archive>
void fields(Archive& archive, SizeStep& s) {
  archive(s.asked, s.vertices, s.error, s.adapted);
}

template <class Archive>
void fields(Archive& archive, InterpolationLimit& l) {
  archive(l.value, l.relative_error, l.degenerate_share);
}

template <class Archive>
void fields(Archive& archive, ErrorNorms& e) {
  archive(e.l1, e.l2, e.linf, e.h1, e.num_nonfinite, e.left_out, e.l2_doubt);
}

template <class Archive>
void fields(Archive& archive, EstimatedError& e) {
  archive(e.l2, e.h1, e.linf, e.interpolation_l2);
}

template <class Archive>
void fields(Archive& archive, WorstElement& w) {
  archive(w.center, w.quality);
}

template <class Archive>
void fields(Archive& archive, GoalError& e) {
  archive(e.error, e.magnitude);
}

template <class Archive>
void fields(Archive& archive, GoalRow& g) {
  archive(g.value, g.estimate, g.error);
}

template <class Archive>
void fields(Archive& archive, IterationRow& r) {
  archive(r.iteration, r.vertices, r.triangles, r.complexity, r.clipped, r.interpolation_error, r.efficiency,
          r.solution_error, r.estimated_error, r.residual_h1, r.goal, r.solve_report, r.fluxes, r.functionals,
          r.unit_edges, r.length_min, r.length_max, r.quality_min, r.quality_p01, r.quality_mean,
          r.quality_min_away_from_corners, r.worst, r.diagnosis, r.start, r.start_reason, r.seconds, r.peak_memory_mb);
}

template <class Archive>
void fields(Archive& archive, Summary& s) {
  archive(s.case_name, s.seed, s.threads, s.stop_reason, s.error_targets_declared, s.targets_met, s.interpolation_limit,
          s.warnings, s.iterations);
}

template <class Archive>
void fields(Archive& archive, LoopState& s) {
  archive(s.last, s.met, s.is_met, s.asked, s.unchanged, s.limits_bind, s.seconds, s.history, s.limit, s.summary);
}

}  // namespace parmesan
