#include "adapt/second_derivatives.h"

#include <functional>

#include "adapt/functional_value.h"
#include "adapt/goal_metric.h"
#include "fem/smooth_parts.h"
#include "mesher/metric/tensor_interpolant.h"

namespace parmesan {
namespace {

std::function<SymmetricTensor(const Point&)> exact_hessian(const Expression& function) {
  return [function](const Point& p) {
    const Jet u = function.jet(p);
    return SymmetricTensor{u.xx, u.xy, u.yy};
  };
}

/// Of a P1 function that is smooth on these parts, or of its dual.
std::vector<Hessian> hessians_on(const SmoothParts& parts, std::span<const double> values, Recovery recovery) {
  return recover_hessians(parts.mesh(), parts.spread(values), recovery);
}

/// The means at the vertices of the whole mesh of what the copies have, weighted by the area around each.
class PartMeans {
 public:
  explicit PartMeans(const SmoothParts& parts) : parts_(parts), share_(parts.mesh().points.size(), 1.0) {
    if (&parts.mesh() == &parts.whole()) return;
    share_ = vertex_areas(parts.mesh());
    const std::vector<double> whole = vertex_areas(parts.whole());
    for (std::size_t v = 0; v < share_.size(); ++v) share_[v] /= whole[source(v)];
  }

  std::vector<AbsoluteHessian> of(std::span<const AbsoluteHessian> copies) const {
    std::vector<AbsoluteHessian> result(parts_.whole().points.size());
    for (std::size_t v = 0; v < copies.size(); ++v) {
      AbsoluteHessian& mean = result[source(v)];
      mean.tensor = mean.tensor + share_[v] * copies[v].tensor;
      mean.negative_share += share_[v] * copies[v].negative_share;
    }
    return result;
  }

  std::vector<SymmetricTensor> of(std::span<const SymmetricTensor> copies) const {
    std::vector<SymmetricTensor> result(parts_.whole().points.size());
    for (std::size_t v = 0; v < copies.size(); ++v) result[source(v)] = result[source(v)] + share_[v] * copies[v];
    return result;
  }

 private:
  std::size_t source(std::size_t v) const { return static_cast<std::size_t>(parts_.source(v)); }

  const SmoothParts& parts_;
  std::vector<double> share_;
};

SecondDerivatives of_given(const Case& input) {
  SecondDerivatives result;
  result.mesh = &input.given->mesh;
  const std::vector<Hessian> recovered = recover_hessians(*result.mesh, input.given->values, input.metric.recovery);
  result.absolute = absolute_hessians(*result.mesh, recovered);
  if (input.lower_error) result.signed_field = std::make_unique<TensorInterpolant>(*result.mesh, recovered);
  return result;
}

SecondDerivatives of_exact(const Case& input, const Iterate& iterate) {
  SecondDerivatives result;
  result.mesh = &iterate.mesh;
  result.absolute = exact_absolute_hessians(iterate.mesh, *input.exact);
  if (input.lower_error) result.signed_field = std::make_unique<CallableTensorField>(exact_hessian(*input.exact));
  return result;
}

SecondDerivatives of_discrete(const Case& input, const Iterate& iterate, const SmoothParts& parts) {
  SecondDerivatives result;
  result.mesh = &iterate.mesh;
  const PartMeans means(parts);
  const std::vector<Hessian> recovered = hessians_on(parts, iterate.values, input.metric.recovery);
  result.absolute = means.of(absolute_hessians(parts.mesh(), recovered));
  if (input.lower_error) {
    result.signed_field = std::make_unique<TensorInterpolant>(iterate.mesh, means.of(recovered));
  }
  return result;
}

}  // namespace

SecondDerivatives second_derivatives(const Case& input, const Iterate& iterate) {
  if (input.given) return of_given(input);
  const std::vector<Side> sides = labelled_sides(iterate.mesh);
  const SmoothParts parts(iterate.mesh, input.problem, sides);
  SecondDerivatives result =
      input.metric.exact_hessian && input.exact ? of_exact(input, iterate) : of_discrete(input, iterate, parts);
  if (input.goal) {
    const GoalFunctional goal = goal_functional(*input.goal, iterate.mesh);
    const SmoothParts dual_parts(iterate.mesh, input.problem, sides, &goal);
    const std::vector<Hessian> dual = hessians_on(dual_parts, iterate.dual, input.metric.recovery);
    result.goal = goal_tensors(iterate.mesh, input.problem, result.absolute,
                               PartMeans(dual_parts).of(absolute_hessians(dual_parts.mesh(), dual)));
  }
  return result;
}

}  // namespace parmesan
