#include "fem/stabilization.h"

#include <algorithm>
#include <cmath>

#include "fem/coefficients.h"

namespace parmesan {

double directional_length(const P1Element& element, const Vector& b) {
  double sum = 0.0;
  for (const Vector& gradient : element.gradient) sum += std::abs(dot(b, gradient));
  return 2.0 * norm(b) / sum;
}

double mesh_peclet(const P1Element& element, const Vector& b, const Diffusion& k) {
  const double speed = norm(b);
  if (speed == 0.0) return 0.0;
  const Vector direction = (1.0 / speed) * b;
  return speed * directional_length(element, direction) / (2.0 * dot(direction, k * direction));
}

double supg_parameter(const P1Element& element, const Vector& b, const Diffusion& k) {
  const double peclet = mesh_peclet(element, b, k);
  if (peclet <= 1.0) return 0.0;
  const double convective = 2.0 * directional_length(element, b) / (3.0 * norm(b)) * (1.0 - 1.0 / peclet);
  double diffusion_rate = 0.0;
  for (const Vector& g : element.gradient) diffusion_rate += dot(g, k * g);
  return std::min(convective, 1.0 / diffusion_rate);
}

}  // namespace parmesan
