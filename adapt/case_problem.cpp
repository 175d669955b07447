#include <algorithm>
#include <memory>

#include "adapt/case.h"
#include "adapt/case_boundary.h"
#include "adapt/case_consistency.h"
#include "adapt/case_equation.h"
#include "adapt/case_reading.h"
#include "adapt/json_text.h"
#include "adapt/nearest_name.h"
#include "adapt/region_names.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

const std::string kProblem = "/problem";

class EquationReader {
 public:
  EquationReader(CaseReading& reading, const CaseGeometry* geometry)
      : reading_(reading), problem_(reading.document.root["problem"]), geometry_(geometry) {}

  std::optional<CheckedExpression> exact() {
    if (!readable("exact")) return std::nullopt;
    return scalar(problem_["exact"], kProblem + "/exact");
  }

  std::optional<Regional<TensorExpressions>> diffusion() {
    return regional<TensorExpressions>("diffusion",
                                       [this](const Json& v, const std::string& p) { return tensor(v, p); });
  }

  std::optional<Regional<VectorExpressions>> velocity() {
    return regional<VectorExpressions>("velocity",
                                       [this](const Json& v, const std::string& p) { return vector(v, p); });
  }

  std::vector<PointSource> point_sources() {
    std::vector<PointSource> sources;
    if (!readable("point_sources")) return sources;
    for (const Json& source : problem_["point_sources"])
      sources.push_back({read_point(source["at"]), source["strength"].get<double>()});
    return sources;
  }

  std::optional<Regional<CheckedExpression>> scalar_field(const std::string& key) {
    return regional<CheckedExpression>(key, [this](const Json& v, const std::string& p) { return scalar(v, p); });
  }

 private:
  bool readable(const std::string& key) const {
    return problem_.contains(key) && reading_.issues.clean(kProblem + "/" + key);
  }

  std::optional<CheckedExpression> scalar(const Json& value, const std::string& pointer) {
    std::optional<Expression> parsed = reading_.expression(value, pointer);
    if (!parsed) return std::nullopt;
    return CheckedExpression(std::move(*parsed), pointer);
  }

  std::optional<VectorExpressions> vector(const Json& value, const std::string& pointer) {
    const std::optional<CheckedExpression> x = scalar(value[0], pointer + "/0");
    const std::optional<CheckedExpression> y = scalar(value[1], pointer + "/1");
    if (!x || !y) return std::nullopt;
    return VectorExpressions{*x, *y};
  }

  /// Numbers, to rounding, or expressions.
  static bool are_equal(const Json& a, const Json& b) {
    constexpr double rounding = 1e-14;
    if (!a.is_number() || !b.is_number()) return a == b;
    const double x = a.get<double>(), y = b.get<double>();
    return std::abs(x - y) <= rounding * std::abs(x);
  }

  std::optional<TensorExpressions> tensor(const Json& value, const std::string& pointer) {
    if (!value.is_array()) {
      const std::optional<CheckedExpression> k = scalar(value, pointer);
      if (!k) return std::nullopt;
      return TensorExpressions{*k, CheckedExpression(Expression::constant(0.0), pointer), *k};
    }
    const std::optional<VectorExpressions> first = vector(value[0], pointer + "/0");
    const std::optional<VectorExpressions> second = vector(value[1], pointer + "/1");
    if (!are_equal(value[0][1], value[1][0])) {
      reading_.issues.add(pointer, "the matrix must be symmetric: entries [0][1] and [1][0] differ");
    }
    if (!first || !second) return std::nullopt;
    return TensorExpressions{first->x, first->y, second->y};
  }

  /// A value for everywhere, or an object region -> value.
  template <class T, class Read>
  std::optional<Regional<T>> regional(const std::string& key, const Read& read) {
    if (!readable(key)) return std::nullopt;
    const Json& value = problem_[key];
    Regional<T> result{kProblem + "/" + key, {}, std::nullopt};
    if (!value.is_object()) {
      result.other = read(value, result.pointer);
      return result.other ? std::optional<Regional<T>>(result) : std::nullopt;
    }
    RegionsByName numbers;
    if (geometry_ != nullptr) numbers = regions_by_name(geometry_->domain);
    for (const auto& [name, member] : value.items()) {
      if (name.starts_with("x-")) continue;
      const std::optional<T> parsed = read(member, result.pointer + pointer_step(name));
      if (!parsed) continue;
      if (name == "*") result.other = parsed;
      const auto found = numbers.find(name);
      if (found == numbers.end()) continue;
      for (const int number : found->second) result.by_region.emplace(number, *parsed);
    }
    if (geometry_ != nullptr) check_regions(value, result.pointer);
    return result;
  }

  void check_regions(const Json& value, const std::string& pointer) {
    std::vector<std::string> names = region_names(geometry_->domain);
    for (const auto& entry : value.items()) {
      const std::string& name = entry.key();
      if (name == "*" || name.starts_with("x-") || std::ranges::binary_search(names, name)) continue;
      const std::string hint = suggestion(name, names);
      reading_.issues.add(pointer + pointer_step(name),
                          "the geometry has no region '" + name.substr(0, 60) + "'" + (hint.empty() ? "." : hint) +
                              " Its regions are: " + quoted_list(names) + ", and \"*\" stands for all others");
    }
    if (value.contains("*")) return;
    if (names.empty()) return reading_.issues.add(pointer, "no value; the geometry has no regions: give one for \"*\"");
    std::erase_if(names, [&value](const std::string& name) { return value.contains(name); });
    if (names.empty()) return;
    reading_.issues.add(pointer,
                        "no value for the regions " + quoted_list(names) + "; give one for each, or for \"*\"");
  }

  CaseReading& reading_;
  const Json& problem_;
  const CaseGeometry* geometry_;
};

bool is_zero(const Regional<CheckedExpression>& field) {
  return field.by_region.empty() && field.other && field.other->is_zero();
}

bool is_zero(const Regional<VectorExpressions>& field) {
  return field.by_region.empty() && field.other && field.other->x.is_zero() && field.other->y.is_zero();
}

ScalarCoefficient coefficient_of(const Regional<CheckedExpression>& field) {
  if (is_zero(field)) return nullptr;
  return [field](const Point& p, int region) { return field.at(region).value(p); };
}

/// The derived source as c u - div(K grad u).
DivergenceForm divergence_form(const std::shared_ptr<const Equation>& equation, const ScalarCoefficient& reaction) {
  DivergenceForm form{[equation](const Point& p, int region) { return equation->exact_flux(p, region); }, nullptr};
  if (!reaction) return form;
  form.remainder = [equation, reaction](const Point& p, int region) {
    return reaction(p, region) * equation->exact->value(p);
  };
  return form;
}

/// The functions that the finite element method asks for.
Problem make_problem(const std::shared_ptr<const Equation>& equation,
                     const std::optional<Regional<CheckedExpression>>& source) {
  Problem problem;
  problem.diffusion = [equation](const Point& p, int region) { return equation->diffusion_at(p, region); };
  if (!is_zero(equation->velocity)) {
    problem.velocity = [equation](const Point& p, int region) {
      const VectorExpressions& b = equation->velocity.at(region);
      return Vector{b.x.value(p), b.y.value(p)};
    };
  }
  problem.reaction = coefficient_of(equation->reaction);
  if (source) {
    problem.source = coefficient_of(*source);
  } else if (equation->exact) {
    problem.source = [equation](const Point& p, int region) { return equation->derived_source(p, region).value; };
    problem.divergence_form = divergence_form(equation, problem.reaction);
  }
  return problem;
}

void read_equation(CaseReading& reading, const CaseGeometry* geometry, Case& result) {
  Json& section = reading.document.root["problem"];
  if (!section.contains("source") && !section.contains("exact")) section["source"] = 0;
  EquationReader reader(reading, geometry);
  auto diffusion = reader.diffusion();
  auto velocity = reader.velocity();
  auto reaction = reader.scalar_field("reaction");
  const auto source = reader.scalar_field("source");
  const auto exact = reader.exact();
  if (exact) result.exact = exact->expression();
  const bool complete = diffusion && velocity && reaction;
  const auto equation = complete ? std::make_shared<const Equation>(Equation{
                                       std::move(*diffusion), std::move(*velocity), std::move(*reaction), exact})
                                 : nullptr;
  if (equation) result.problem = make_problem(equation, source);
  result.problem.point_sources = reader.point_sources();
  // -div(K grad exact) has them already; derived point by point it does not.
  if (!result.problem.point_sources.empty()) result.problem.divergence_form.reset();
  result.problem.stabilize = section.value("stabilize", Json(true)) == true;
  result.problem.capture_discontinuities = section.value("discontinuity_capturing", Json(false)) == true;
  result.problem.correct_defect = section.value("defect_correction", Json(false)) == true;
  if (result.problem.correct_defect && result.problem.capture_discontinuities) {
    reading.issues.add("/problem/defect_correction",
                       "takes back what 'discontinuity_capturing' adds; leave one of them out");
  }
  if (geometry == nullptr) return;
  result.problem.boundary = read_boundary(reading, *geometry, equation);
  if (equation && exact && reading.issues.empty()) {
    check_consistency(reading, *geometry, *equation, source, result.problem);
  }
}

}  // namespace

void read_problem_section(CaseReading& reading, const CaseGeometry* geometry, Case& result) {
  const Json& root = reading.document.root;
  if (!root.contains("problem") || !root["problem"].is_object()) return;
  const Json& problem = root["problem"];
  if (!problem.contains("interpolate")) return read_equation(reading, geometry, result);
  result.interpolation = true;
  const std::string pointer = kProblem + "/interpolate";
  if (!reading.issues.clean(pointer)) return;
  if (problem["interpolate"].is_object())
    result.given = read_given_field(reading);
  else
    result.exact = reading.expression(problem["interpolate"], pointer);
}

}  // namespace parmesan
