#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "adapt/case.h"
#include "adapt/case_reading.h"
#include "adapt/idle_options.h"
#include "adapt/json_text.h"
#include "adapt/nearest_name.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

template <class Names>
auto named(const Json& section, const char* key, const Names& names) {
  return named_value(names, section[key].get<std::string>());
}

constexpr std::array<OptionName<Recovery>, 4> recovery_names{
    {{"least-squares", Recovery::LeastSquares},
     {"double-projection", Recovery::DoubleProjection},
     {"zienkiewicz-zhu", Recovery::ZienkiewiczZhu},
     {"polynomial-preserving", Recovery::PolynomialPreserving}}};

/// A size that is constant or varies.
struct SizeLimit {
  double constant = 0.0;
  std::optional<Expression> varying;
};

SizeLimit read_size_limit(CaseReading& reading, Json& section, const std::string& key) {
  std::optional<Expression> size = reading.expression(section[key], "/metric/" + key);
  if (!size) return {};
  if (!size->is_constant()) return {0.0, std::move(size)};
  const double constant = size->value({});
  if (std::isfinite(constant) && constant >= 0.0) {
    section[key] = constant;
    return {constant, std::nullopt};
  }
  reading.issues.add("/metric/" + key, "must be a size, or 0 for none, not " + text(constant));
  return {};
}

constexpr std::array<OptionName<SolverMethod>, 6> method_names{{{"automatic", SolverMethod::Automatic},
                                                                {"ldlt", SolverMethod::Ldlt},
                                                                {"lu", SolverMethod::Lu},
                                                                {"cg", SolverMethod::Cg},
                                                                {"bicgstab", SolverMethod::BiCgStab},
                                                                {"gmres", SolverMethod::Gmres}}};
constexpr std::array<OptionName<Preconditioner>, 4> preconditioner_names{{{"automatic", Preconditioner::Automatic},
                                                                          {"jacobi", Preconditioner::Jacobi},
                                                                          {"ilut", Preconditioner::IncompleteLu},
                                                                          {"multigrid", Preconditioner::Multigrid}}};

void read_solver(CaseReading& reading, const Json& section, Case& result) {
  const std::string method = section["method"].get<std::string>();
  SolverOptions& solver = result.problem.solver;
  solver.method = named_value(method_names, method);
  solver.preconditioner = named(section, "preconditioner", preconditioner_names);
  solver.restart = static_cast<int>(section["restart"].get<double>());
  const bool needs_symmetry = solver.method == SolverMethod::Cg || solver.method == SolverMethod::Ldlt;
  if (needs_symmetry && result.problem.velocity) {
    reading.issues.add("/solver/method",
                       "'" + method + "' needs a symmetric matrix; with a velocity use 'bicgstab', 'gmres' or 'lu'");
  }
  if (solver.method == SolverMethod::Cg && solver.preconditioner == Preconditioner::IncompleteLu) {
    reading.issues.add("/solver/preconditioner", "'cg' needs a symmetric one, 'multigrid' or 'jacobi'");
  }
}

void read_metric(CaseReading& reading, Json& section, Case& result) {
  MetricOptions& metric = result.metric;
  const bool sign_aware = section["kind"] == "sign-aware";
  metric.kind = sign_aware ? MetricKind::SignAware : MetricKind::LoseilleAlauzet;
  const Json& norm = section["norm"];
  metric.norm = norm.is_string() ? std::numeric_limits<double>::infinity() : norm.get<double>();
  // What a solution gets wrong from vertex to vertex must be smoothed; given values are right.
  if (!section.contains("recovery")) section["recovery"] = result.interpolation ? "least-squares" : "zienkiewicz-zhu";
  metric.exact_hessian = section["recovery"] == "exact";
  if (!metric.exact_hessian) metric.recovery = named(section, "recovery", recovery_names);
  if (section["interpolation"] == "linear") metric.interpolation = MetricInterpolation::Linear;
  SizeLimit h_min = read_size_limit(reading, section, "h_min");
  SizeLimit h_max = read_size_limit(reading, section, "h_max");
  metric.h_min = h_min.constant;
  metric.h_max = h_max.constant;
  metric.h_min_at = std::move(h_min.varying);
  metric.h_max_at = std::move(h_max.varying);
  if (!section.contains("max_aspect"))
    section["max_aspect"] = result.interpolation ? Json(metric.max_aspect) : "automatic";
  metric.automatic_aspect = section["max_aspect"] == "automatic" && !result.interpolation;
  if (section["max_aspect"].is_number()) metric.max_aspect = section["max_aspect"].get<double>();
  metric.gradation = section["gradation"].get<double>();
  if (metric.h_max > 0.0 && metric.h_min > metric.h_max) {
    reading.issues.add("/metric/h_min", "must not be larger than 'h_max'");
  }
  if (metric.gradation > 0.0 && metric.gradation <= 1.0) {
    reading.issues.add("/metric/gradation", "must be 0 (none) or above 1: by this factor sizes may grow per edge");
  }
  if (metric.exact_hessian && !result.exact) {
    reading.issues.add("/metric/recovery", "'exact' needs the exact solution in problem.exact");
  }
}

template <class T, std::size_t N>
std::optional<T> optional_name(const Json& section, const char* key, const std::array<OptionName<T>, N>& names) {
  if (!section.contains(key)) return std::nullopt;
  return named(section, key, names);
}

ParticleOptions read_particles(const Json& section) {
  return {.potential = named(section, "potential", potential_names),
          .decay = section["decay"].get<double>(),
          .neighbourhood = named(section, "neighbourhood", neighbourhood_names),
          .radius = section["radius"].get<double>(),
          .force = named(section, "force", force_names),
          .distance = named(section, "distance", distance_names),
          .step = optional_number(section, "step"),
          .momentum = optional_number(section, "momentum"),
          .virtual_triangles = section["virtual_triangles"].get<bool>(),
          .creation = named(section, "creation", creation_names),
          .annihilation = optional_name(section, "annihilation", annihilation_names),
          .alive_speed = section["alive_speed"].get<double>(),
          .relocation = named(section, "relocation", relocation_names),
          .picking = named(section, "picking", picking_names),
          .max_picks = section["max_picks"].get<double>()};
}

void read_mesher(CaseReading& reading, const Json& section, Case& result) {
  GenerateOptions& mesher = result.mesher;
  mesher.schedule = named(section, "schedule", schedule_names);
  mesher.particles = read_particles(section["particles"]);
  mesher.preset = named(section, "preset", preset_names);
  for (const IdleOption& idle : idle_options(mesher)) reading.issues.add("/mesher" + idle.pointer, idle.problem);
  mesher.chord_error = section["chord_error"].get<double>();
  mesher.seed = static_cast<std::uint64_t>(section["seed"].get<double>());
  result.lower_error = section["lower_error"].get<bool>();
  const Targets& targets = result.targets;
  const bool only_h1 = targets.h1_error && !targets.l2_error && !targets.linf_error;
  if (result.lower_error && result.metric.norm != 2.0) {
    reading.issues.add("/mesher/lower_error", "lowers the L2 error only: needs the norm 2 in metric.norm");
  }
  const bool only_goal = result.goal && !targets.l2_error && !targets.linf_error && !targets.h1_error;
  if (result.lower_error && only_goal) {
    reading.issues.add("/mesher/lower_error", "lowers the L2 error only: of no use to a goal alone");
  }
  if (result.lower_error && only_h1) {
    reading.issues.add("/mesher/lower_error", "lowers the L2 error only: of no use to the one target 'h1_error'");
  }
}

void read_initial(CaseReading& reading, const Json& section, Case& result) {
  result.initial_vertices = *optional_count(section, "vertices");
  result.continuation = section["continuation"].get<double>();
  if (result.interpolation && result.continuation > 1.0)
    reading.issues.add("/initial/continuation",
                       "is for the diffusion of a problem, and an interpolated function has none");
}

/// Limits on the field with this path; value: { "min": a, "max": b }.
Expectation read_limits(CaseReading& reading, const std::string& pointer, std::vector<std::string> path,
                        const Json& value) {
  Expectation limits{std::move(path), optional_number(value, "min"), optional_number(value, "max"), std::nullopt};
  if (limits.min && limits.max && *limits.min > *limits.max)
    reading.issues.add(pointer + "/min", "must not be larger than 'max'");
  return limits;
}

/// Limits on the members of "functionals" or "fluxes", which group is; known: the names that there are.
void read_group(CaseReading& reading, const std::string& group, const Json& section,
                const std::vector<std::string>& known, Case& result) {
  for (const auto& [name, value] : section.items()) {
    if (name.starts_with("x-")) continue;
    const std::string pointer = "/expect/" + group + pointer_step(name);
    if (std::ranges::find(known, name) == known.end()) {
      const std::string hint = suggestion(name, known);
      reading.issues.add(pointer, "'" + name.substr(0, 60) + "' is none of the " + group + (hint.empty() ? "." : hint) +
                                      " There are: " + quoted_list(known));
    }
    result.expect.push_back(read_limits(reading, pointer, {group, name}, value));
  }
}

// The names of the labels with a condition, through which fluxes are told.
std::vector<std::string> flux_names(const Case& read) {
  std::vector<std::string> names;
  for (const auto& entry : read.problem.boundary) {
    std::string name = label_name(read.domain.label_names, entry.first);
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

std::vector<std::string> split_at_dots(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

void read_expectations(CaseReading& reading, const Json& section, Case& result) {
  for (const auto& [name, value] : section.items()) {
    if (name.starts_with("x-")) continue;
    if (name == "functionals") {
      read_group(reading, name, value, names_of(result.functionals), result);
      continue;
    }
    if (name == "fluxes") {
      read_group(reading, name, value, flux_names(result), result);
      continue;
    }
    const std::string pointer = "/expect/" + name;
    const bool is_flag = name == "targets_met";
    if (value.is_boolean() != is_flag) {
      reading.issues.add(pointer, is_flag ? "must be true or false" : "must be { \"min\": a, \"max\": b }");
    } else if (is_flag) {
      result.expect.push_back({{name}, std::nullopt, std::nullopt, value.get<bool>()});
    } else {
      result.expect.push_back(read_limits(reading, pointer, split_at_dots(name), value));
    }
  }
}

}  // namespace

void read_option_sections(CaseReading& reading, Case& result) {
  Json& root = reading.document.root;
  const auto clean = [&reading](const std::string& name) { return reading.issues.clean("/" + name); };
  if (clean("solver")) read_solver(reading, root["solver"], result);
  if (clean("metric")) read_metric(reading, root["metric"], result);
  if (clean("targets")) read_targets(reading, root["targets"], result);
  if (clean("mesher")) read_mesher(reading, root["mesher"], result);
  if (clean("initial")) read_initial(reading, root["initial"], result);
  if (clean("output")) result.output.formats = root["output"]["formats"].get<std::vector<std::string>>();
  const auto is_read = [&](const char* name) { return root.contains(name) && clean(name); };
  const bool names_are_known = is_read("geometry") && is_read("problem") && clean("functionals");
  if (clean("expect") && names_are_known) read_expectations(reading, root["expect"], result);
}

}  // namespace parmesan
