#include "adapt/functional_value.h"

#include <set>

#include "adapt/case_equation.h"
#include "fem/functionals.h"

namespace parmesan {
namespace {

double weight_at(const CaseFunctional& functional, const Point& p) {
  if (!functional.weight) return 1.0;
  return CheckedExpression(*functional.weight, "/functionals/" + functional.name + "/weight").value(p);
}

double integral(const CaseFunctional& functional, const Mesh& mesh, std::span<const double> values) {
  const auto weight = [&](const Point& p, int region) {
    const bool inside = functional.where == "*" || label_name(mesh.region_names, region) == functional.where;
    return inside ? weight_at(functional, p) : 0.0;
  };
  return value_of(region_integral(mesh, weight), values);
}

double boundary(const CaseFunctional& functional, const Mesh& mesh, std::span<const double> values,
                const std::map<int, double>& fluxes) {
  double sum = 0.0;
  const auto weight = [&](const Point& p, const Vector&, int) { return weight_at(functional, p); };
  const std::vector<Side> sides = labelled_sides(mesh);
  for (const int label : std::set<int>(mesh.labels.begin(), mesh.labels.end())) {
    if (functional.where != "*" && functional.where != label_name(mesh.label_names, label)) continue;
    if (functional.kind == CaseFunctional::Kind::BoundaryIntegral) {
      sum += value_of(boundary_integral(mesh, sides, label, weight), values);
    } else if (fluxes.contains(label)) {
      sum += fluxes.at(label);
    }
  }
  return sum;
}

}  // namespace

double evaluate(const CaseFunctional& functional, const Mesh& mesh, std::span<const double> values,
                const std::map<int, double>& fluxes) {
  if (functional.kind == CaseFunctional::Kind::Value) return value_of(point_value(mesh, functional.point), values);
  if (functional.kind == CaseFunctional::Kind::Integral) return integral(functional, mesh, values);
  return boundary(functional, mesh, values, fluxes);
}

}  // namespace parmesan
