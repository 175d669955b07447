#include "tools/cli/results.h"

#include <algorithm>
#include <array>
#include <ostream>

#include "adapt/number_text.h"
#include "mesher/io/mesh_file.h"
#include "tools/cli/escape.h"
#include "tools/cli/exit_code.h"

namespace parmesan {
namespace {

void print_norms(std::ostream& out, const char* name, const std::optional<ErrorNorms>& norms) {
  if (!norms) return;
  out << name << "L2 " << short_number(norms->l2) << ", H1 " << short_number(norms->h1) << ", max "
      << short_number(norms->linf) << "\n";
}

void print_named(std::ostream& out, const char* what, const std::map<std::string, double>& named) {
  if (named.empty()) return;
  out << what;
  const char* separator = "";
  for (const auto& [name, value] : named) {
    out << separator << escape_control(name) << " " << short_number(value, 6);
    separator = ", ";
  }
  out << "\n";
}

void print_solve(std::ostream& out, const SolveReport& report) {
  out << "solver:              " << report.solver << ", " << report.unknowns << " unknowns, backward error "
      << short_number(report.backward_error, 2);
  if (report.peclet_max > 0.0) {
    out << ", mesh Peclet numbers " << short_number(report.peclet_min, 2) << " to "
        << short_number(report.peclet_max, 2);
  }
  out << "\n";
  const auto exceeds = [&out](double by, const char* side, double bound) {
    out << "maximum principle:   " << side << " bound " << short_number(bound) << " exceeded by " << short_number(by, 2)
        << "\n";
  };
  if (report.undershoot() > 0.0) exceeds(report.undershoot(), "lower", *report.bounds.lower);
  if (report.overshoot() > 0.0) exceeds(report.overshoot(), "upper", *report.bounds.upper);
}

void print_goal(std::ostream& out, const GoalRow& goal) {
  out << "goal:                " << short_number(goal.value, 8) << ", estimated error "
      << short_number(goal.estimate.error);
  if (goal.error) {
    out << ", error " << short_number(*goal.error) << ", effectivity "
        << short_number(goal.estimate.error / *goal.error);
  }
  out << "; corrected by it " << short_number(goal.corrected(), 8);
  if (goal.error) out << ", error " << short_number(*goal.corrected_error());
  out << "\n";
}

void print_row(std::ostream& out, const IterationRow& row) {
  out << "mesh:                " << row.vertices << " vertices, " << row.triangles << " triangles, "
      << short_number(100.0 * row.unit_edges) << " % unit edges, quality " << short_number(row.quality_mean) << " (min "
      << short_number(row.quality_min) << ")\n";
  print_norms(out, "solution error:      ", row.solution_error);
  print_norms(out, "interpolation error: ", row.interpolation_error);
  if (row.estimated_error) {
    out << "estimated error:     L2 " << short_number(row.estimated_error->l2) << ", H1 "
        << short_number(row.estimated_error->h1) << ", max " << short_number(row.estimated_error->linf);
    if (row.residual_h1) out << "; H1 by residuals " << short_number(*row.residual_h1);
    out << "\n";
  }
  if (row.goal) print_goal(out, *row.goal);
  if (row.efficiency) out << "efficiency:          " << short_number(*row.efficiency) << "\n";
  if (row.solve_report) print_solve(out, *row.solve_report);
  print_named(out, "functionals:         ", row.functionals);
}

std::string_view words(Start start) {
  switch (start) {
    case Start::Scratch:
      return "scratch";
    case Start::PreviousMesh:
      return "the previous mesh";
    case Start::RefinedPreviousMesh:
      return "the previous mesh, refined";
  }
  return "";
}

}  // namespace

void print_summary(std::ostream& out, const RunResult& result) {
  const Summary& summary = result.summary;
  out << escape_control(summary.case_name) << ": " << to_string(summary.stop_reason) << " after "
      << summary.iterations.size() << " iterations, targets " << (summary.targets_met ? "met" : "not met") << "\n";
  if (!summary.iterations.empty()) print_row(out, summary.iterations.back());
  out << "written:             " << escape_control(result.out_dir) << ", to be looked at in its report.html\n";
}

bool all_passed(std::ostream& out, std::span<const Verdict> verdicts) {
  for (const Verdict& verdict : verdicts) {
    out << (verdict.passed ? "passed: " : "MISSED: ") << escape_control(verdict.message) << "\n";
  }
  return std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& verdict) { return verdict.passed; });
}

void warn_of_written(const std::string& path, const Mesh& mesh, const MeshFields& fields) {
  for (const std::string& note : notes_on_written(path, mesh, fields)) print_warning(note);
}

void print_mesh_summary(std::ostream& out, const GenerateResult& made, const MeshQuality& quality) {
  out << made.mesh.num_vertices() << " vertices, " << made.mesh.num_triangles() << " triangles\n"
      << short_number(100.0 * quality.unit_edges) << " % unit edges, lengths " << short_number(quality.length_min)
      << " to " << short_number(quality.length_max) << ", quality mean " << short_number(quality.quality_mean)
      << ", min " << short_number(quality.quality_min) << "\n"
      << "started from " << words(made.report.start) << ": " << made.report.start_reason << "\n";
  if (!made.report.thesis) return;
  const ThesisReport& thesis = *made.report.thesis;
  const double per_particle = static_cast<double>(thesis.picks) / made.mesh.num_vertices();
  out << thesis.picks << " picks, " << short_number(per_particle) << " per particle; " << thesis.created << " created, "
      << thesis.annihilated << " annihilated; "
      << (thesis.settled ? "none is alive" : std::to_string(thesis.alive) + " are alive") << "\n";
}

}  // namespace parmesan
