#include "adapt/case_boundary.h"

#include <algorithm>
#include <array>
#include <set>

#include "adapt/json_text.h"
#include "adapt/nearest_name.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

const std::string kBoundary = "/problem/boundary";

/// An expression on the boundary, with what 'exact' means in it.
BoundaryData data_of(const CheckedExpression& expression, const BoundaryData& exact) {
  const bool needs_exact = expression.expression().uses("exact");
  return [expression, exact, needs_exact](const Point& p, const Vector& normal, int region) {
    const std::array<double, 3> extra{normal.x, normal.y, needs_exact ? exact(p, normal, region) : 0.0};
    return expression.value(p, extra);
  };
}

class ConditionReader {
 public:
  ConditionReader(CaseReading& reading, std::shared_ptr<const Equation> equation)
      : reading_(reading), equation_(std::move(equation)) {}

  std::optional<BoundaryCondition> read(const Json& value, const std::string& pointer) {
    if (!reading_.issues.clean(pointer)) return std::nullopt;
    if (value.contains("dirichlet")) return dirichlet(value["dirichlet"], pointer + "/dirichlet");
    if (value.contains("neumann")) return neumann(value["neumann"], pointer + "/neumann");
    return robin(value["robin"], pointer + "/robin");
  }

 private:
  std::optional<CheckedExpression> expression(const Json& value, const std::string& pointer, bool with_exact = true) {
    std::vector<std::string> extra{"nx", "ny"};
    if (with_exact && reading_.document.root["problem"].contains("exact")) extra.emplace_back("exact");
    std::optional<Expression> parsed = reading_.expression(value, pointer, extra);
    if (!parsed) return std::nullopt;
    return CheckedExpression(std::move(*parsed), pointer);
  }

  std::optional<BoundaryCondition> dirichlet(const Json& value, const std::string& pointer) {
    const std::optional<CheckedExpression> data = expression(value, pointer);
    if (!data) return std::nullopt;
    const auto exact = [equation = equation_](const Point& p, const Vector&, int) { return equation->exact->value(p); };
    return BoundaryCondition{BoundaryKind::Dirichlet, data_of(*data, exact), nullptr};
  }

  std::optional<BoundaryCondition> neumann(const Json& value, const std::string& pointer) {
    const std::optional<CheckedExpression> data = expression(value, pointer);
    if (!data) return std::nullopt;
    const auto exact = [equation = equation_](const Point& p, const Vector& normal, int region) {
      return equation->exact_flux(p, normal, region);
    };
    return BoundaryCondition{BoundaryKind::Neumann, data_of(*data, exact), nullptr};
  }

  std::optional<BoundaryCondition> robin(const Json& value, const std::string& pointer) {
    const std::optional<CheckedExpression> factor = expression(value["coefficient"], pointer + "/coefficient", false);
    const std::optional<CheckedExpression> data = expression(value["value"], pointer + "/value");
    if (!factor || !data) return std::nullopt;
    const BoundaryData coefficient = data_of(*factor, nullptr);
    const auto exact = [equation = equation_, coefficient](const Point& p, const Vector& normal, int region) {
      return equation->exact_flux(p, normal, region) + coefficient(p, normal, region) * equation->exact->value(p);
    };
    return BoundaryCondition{BoundaryKind::Robin, data_of(*data, exact), coefficient};
  }

  CaseReading& reading_;
  std::shared_ptr<const Equation> equation_;
};

std::vector<std::string> names_of(const CaseGeometry& geometry, const std::vector<int>& labels) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const int label : labels) {
    const std::string name = label_name(geometry.domain.label_names, label);
    if (seen.insert(name).second) names.push_back(name);
  }
  return names;
}

/// Every key must be a label; every side must have a key.
void check_labels(CaseReading& reading, const CaseGeometry& geometry, const Json& boundary) {
  std::vector<std::string> sides = names_of(geometry, geometry.sides);
  std::vector<std::string> known = sides;
  for (const std::string& name : names_of(geometry, geometry.optional)) known.push_back(name);
  for (const auto& entry : boundary.items()) {
    const std::string& key = entry.key();
    if (key == "*" || key.starts_with("x-") || std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string hint = suggestion(key, known);
    reading.issues.add(kBoundary + pointer_step(key),
                       "the geometry has no side '" + key.substr(0, 60) + "'" + (hint.empty() ? "." : hint) +
                           " Its sides are: " + quoted_list(known) + ", and \"*\" stands for all others");
  }
  if (boundary.contains("*")) return;
  std::erase_if(sides, [&boundary](const std::string& side) { return boundary.contains(side); });
  if (sides.empty()) return;
  reading.issues.add(
      kBoundary, "no condition for the sides " + quoted_list(sides) + "; give one for each, or for \"*\" (all others)");
}

}  // namespace

std::map<int, BoundaryCondition> read_boundary(CaseReading& reading, const CaseGeometry& geometry,
                                               const std::shared_ptr<const Equation>& equation) {
  std::map<int, BoundaryCondition> conditions;
  const Json& problem = reading.document.root["problem"];
  if (!problem.contains("boundary") || !problem["boundary"].is_object()) return conditions;
  const Json& boundary = problem["boundary"];
  std::map<std::string, std::optional<BoundaryCondition>> by_name;
  ConditionReader reader(reading, equation);
  for (const auto& [key, value] : boundary.items()) {
    if (!key.starts_with("x-")) by_name[key] = reader.read(value, kBoundary + pointer_step(key));
  }
  check_labels(reading, geometry, boundary);
  // Inner lines take the condition of their name only; which labels of a file are inside the mesh will show.
  const auto assign = [&](int label, bool may_be_side) {
    auto found = by_name.find(label_name(geometry.domain.label_names, label));
    const bool is_named = found != by_name.end();
    if (!is_named && may_be_side) found = by_name.find("*");
    if (found == by_name.end() || !found->second) return;
    conditions[label] = *found->second;
    conditions[label].on_constraints = is_named;
  };
  for (const int label : geometry.sides) assign(label, true);
  const bool from_file = geometry.sides.empty();
  for (const int label : geometry.optional) assign(label, from_file);
  return conditions;
}

}  // namespace parmesan
