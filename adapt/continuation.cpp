#include "adapt/continuation.h"

namespace parmesan {

std::vector<double> continuation_factors(double largest) {
  constexpr double step = 4.0;  // layers as thick as the root of the diffusion become half as thick
  std::vector<double> factors;
  double factor = largest;
  while (factor > 1.0) {
    factors.push_back(factor);
    factor /= step;
  }
  return factors;
}

Case with_larger_diffusion(const Case& input, double factor) {
  Case result = input;
  result.problem.diffusion = [factor, own = input.problem.diffusion](const Point& p, int region) {
    const Diffusion k = own(p, region);
    return factor * k;
  };
  result.exact.reset();
  result.metric.exact_hessian = false;
  result.metric.automatic_aspect = false;
  return result;
}

}  // namespace parmesan
