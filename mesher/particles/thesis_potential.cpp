#include "mesher/particles/thesis_potential.h"

#include <array>
#include <cmath>
#include <numbers>

namespace parmesan {

double Potential::derivative(double l) const {
  const double square = l * l;
  switch (kind_) {
    case PotentialKind::Gaussian:  // printed without the minus of phi = -exp(-2 l^2)
      return 4.0 * l * std::exp(-2.0 * square);
    case PotentialKind::GaussianDerivative:
      return (1.0 - square) * std::exp(-0.5 * square);
    case PotentialKind::LennardJones:  // phi = 12 l^-6 - 6 l^-12, printed without the signs of the exponents
      return 72.0 * (std::pow(l, -13) - std::pow(l, -7));
    case PotentialKind::Shimada:
      return l < 1.5 ? (1.25 * l - 2.375) * square + 1.125 : 0.0;
    case PotentialKind::LennardJonesApproximation:
      return (1.0 - square * square) * std::exp(-decay_ * square * square);
    case PotentialKind::Laplacian:  // printed without l: the step is delta sum r
      return -0.5 * l;
    case PotentialKind::LengthError:
      return 1.0 - l;
    case PotentialKind::RatioError:  // printed without the minus
      return -std::log(l) / l;
  }
  return 0.0;
}

namespace {

// Six neighbours at distance l: of a displacement dx, half of each pair feels phi'', half phi' / l.
double stiffness_of_ring(const Potential& potential, double l) {
  constexpr double h = 1e-5;
  const double second = (potential.derivative(l + h) - potential.derivative(l - h)) / (2.0 * h);
  return -6.0 * (second + potential.derivative(l) / l);
}

}  // namespace

double newton_step(const Potential& potential, Neighbourhood neighbourhood, double radius) {
  constexpr std::array<double, 4> rings{1.0, std::numbers::sqrt3, 2.0, 3.0};
  const double of_first = stiffness_of_ring(potential, 1.0);
  double stiffness = of_first;
  for (std::size_t i = 1; i < rings.size(); ++i) {
    const bool is_in = neighbourhood == Neighbourhood::N2 ? rings[i] <= 2.0 : rings[i] < radius;
    if (neighbourhood != Neighbourhood::N1 && is_in) stiffness += stiffness_of_ring(potential, rings[i]);
  }
  return 1.0 / (stiffness > 0.5 * of_first ? stiffness : of_first);
}

}  // namespace parmesan
