#include <algorithm>
#include <string>
#include <vector>

#include "adapt/case.h"
#include "adapt/case_reading.h"
#include "adapt/nearest_name.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

// The functional that targets.goal names; the only one where a goal_error is given without a name.
void read_goal(CaseReading& reading, const Json& section, Case& result) {
  if (!section.contains("goal") && !section.contains("goal_error")) return;
  const std::vector<std::string> names = names_of(result.functionals);
  const std::string pointer = section.contains("goal") ? "/targets/goal" : "/targets/goal_error";
  const std::string known = names.empty() ? "none" : quoted_list(names);
  if (result.interpolation) {
    return reading.issues.add(pointer, "a function that is interpolated has no goal; give an equation");
  }
  if (result.problem.correct_defect) {
    return reading.issues.add(
        pointer, "corrects its own values by the dual solution: leave 'defect_correction' out of the problem");
  }
  if (!reading.issues.clean("/functionals")) return;
  if (!section.contains("goal") && names.size() != 1) {
    return reading.issues.add(pointer, "needs 'goal', the name of a functional. There are: " + known);
  }
  const std::string name = section.value("goal", names.empty() ? "" : names.front());
  const auto found = std::ranges::find(result.functionals, name, &CaseFunctional::name);
  if (found == result.functionals.end()) {
    const std::string hint = suggestion(name, names);
    return reading.issues.add(pointer, "there is no functional '" + name.substr(0, 60) + "'" +
                                           (hint.empty() ? "." : hint) + " There are: " + known);
  }
  result.goal = *found;
}

}  // namespace

void read_targets(CaseReading& reading, const Json& section, Case& result) {
  Targets& targets = result.targets;
  targets.l2_error = optional_number(section, "l2_error");
  targets.h1_error = optional_number(section, "h1_error");
  targets.linf_error = optional_number(section, "linf_error");
  targets.goal_error = optional_number(section, "goal_error");
  targets.vertices = optional_count(section, "vertices");
  targets.max_vertices = optional_count(section, "max_vertices");
  targets.max_iterations = static_cast<int>(section["max_iterations"].get<double>());
  targets.max_seconds = optional_number(section, "max_seconds");
  if (targets.vertices && targets.max_vertices && *targets.vertices > *targets.max_vertices) {
    reading.issues.add("/targets/vertices", "must not be larger than 'max_vertices'");
  }
  read_goal(reading, section, result);
}

}  // namespace parmesan
