#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace parmesan {

/// The approximation of Lennard-Jones forces, phi'(l) = (1 - l^4) exp(-d l^4) (thesis 3.20).
///
/// Particles nearer than 1 repel, farther ones attract each other, and only weakly when far.
struct LennardJonesApproximation {
  double decay = 1.0;  // d

  /// phi'(l) / l as a function of l^2 (no root of the squared length is taken twice).
  double force_over_length(double squared_length) const {
    const double fourth = squared_length * squared_length;
    return (1.0 - fourth) * std::exp(-decay * fourth) / std::sqrt(squared_length);
  }

  /// Step delta of 3.12 at which particles on a hexagonal lattice with their neighbours fixed
  /// return fastest in practice; Newton's own step there is e/24 = 0.113.
  static constexpr double step = 0.136;
};

/// phi'(l) / l of a potential, tabulated over l^2: an exponential and a root per neighbour would
/// cost more than all else of a step. Linear interpolation, error below 1e-4 for l > 1/4; nearer
/// particles are evaluated exactly, farther ones than l = 2 exert no force (3.20: below 2e-6).
template <class Potential>
class ForceTable {
 public:
  explicit ForceTable(const Potential& potential) : potential_(potential) {
    for (std::size_t i = 1; i < values_.size(); ++i)
      values_[i] = potential.force_over_length(static_cast<double>(i) / per_unit);
    values_.back() = 0.0;
  }

  double force_over_length(double squared_length) const {
    if (squared_length >= end) return 0.0;
    if (squared_length < begin) return potential_.force_over_length(squared_length);
    const double position = squared_length * per_unit;
    const auto i = static_cast<std::size_t>(position);
    return values_[i] + (position - static_cast<double>(i)) * (values_[i + 1] - values_[i]);
  }

 private:
  static constexpr double begin = 1.0 / 16.0;
  static constexpr double end = 4.0;
  static constexpr int per_unit = 1024;
  Potential potential_;
  std::array<double, static_cast<std::size_t>(end) * per_unit + 1> values_{};
};

}  // namespace parmesan
