#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace parmesan {

/// An exact sum of doubles: non-overlapping components, none zero, of increasing magnitude
/// (Shewchuk, Discrete Comput. Geom. 18, 1997). No components stand for zero.
///
/// Capacity is the most components the value can have, known at compile time; the storage is on
/// the stack and not initialised. Exact unless a product over- or underflows.
template <std::size_t Capacity>
class Expansion {
 public:
  Expansion() {}  // NOLINT: leaves the components uninitialised

  std::size_t size() const { return size_; }
  double operator[](std::size_t i) const { return components_[i]; }

  /// Adds a component that is not smaller than those before it; zeros are left out.
  void append(double component) {
    if (component != 0.0) components_[size_++] = component;
  }

  void clear() { size_ = 0; }

  /// The component that dominates: has the sign of the exact value and is close to it.
  double leading() const { return size_ == 0 ? 0.0 : components_[size_ - 1]; }

 private:
  std::array<double, Capacity> components_;
  std::size_t size_ = 0;
};

/// a + b = value + error exactly.
struct ExactPair {
  double value;
  double error;
};

/// Knuth's two-sum: holds for any a, b that do not overflow.
inline ExactPair two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// Dekker's split of a double into two halves of at most 26 bits: value has the upper, error the lower.
inline ExactPair split(double a) {
  const double c = 134217729.0 * a;  // 2^27 + 1
  const double upper = c - (c - a);
  return {upper, a - upper};
}

/// Dekker's exact product, without fused multiply-add so that every machine computes the same.
inline ExactPair two_product(double a, double b) {
  const double product = a * b;
  const auto [a_upper, a_lower] = split(a);
  const auto [b_upper, b_lower] = split(b);
  const double rest = ((a_upper * b_upper - product) + a_upper * b_lower) + a_lower * b_upper;
  return {product, a_lower * b_lower + rest};
}

/// The exact difference a - b.
inline Expansion<2> exact_difference(double a, double b) {
  const ExactPair d = two_sum(a, -b);
  Expansion<2> result;
  result.append(d.error);
  result.append(d.value);
  return result;
}

/// Fast expansion sum with zero elimination (p. 320).
template <std::size_t N, std::size_t M>
Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<N + M> result;
  std::size_t i = 0;
  std::size_t j = 0;
  double carry = 0.0;
  while (i < e.size() || j < f.size()) {
    const bool take_e = j == f.size() || (i < e.size() && std::abs(e[i]) < std::abs(f[j]));
    const ExactPair s = two_sum(carry, take_e ? e[i++] : f[j++]);
    result.append(s.error);
    carry = s.value;
  }
  result.append(carry);
  return result;
}

template <std::size_t N>
Expansion<N> operator-(const Expansion<N>& e) {
  Expansion<N> result;
  for (std::size_t i = 0; i < e.size(); ++i) result.append(-e[i]);
  return result;
}

template <std::size_t N, std::size_t M>
Expansion<N + M> operator-(const Expansion<N>& e, const Expansion<M>& f) {
  return e + (-f);
}

/// Scale expansion with zero elimination (p. 325).
template <std::size_t N>
Expansion<2 * N> operator*(const Expansion<N>& e, double b) {
  Expansion<2 * N> result;
  double carry = 0.0;
  for (std::size_t i = 0; i < e.size(); ++i) {
    const ExactPair product = two_product(e[i], b);
    const ExactPair lower = two_sum(carry, product.error);
    const ExactPair upper = two_sum(product.value, lower.value);
    result.append(lower.error);
    result.append(upper.error);
    carry = upper.value;
  }
  result.append(carry);
  return result;
}

/// Exact product: e times each component of f, added up from the smallest.
template <std::size_t N, std::size_t M>
Expansion<2 * N * M> operator*(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<2 * N * M> result;
  for (std::size_t j = 0; j < f.size(); ++j) {
    const Expansion<2 * N> term = e * f[j];
    const auto sum = result + term;
    result.clear();
    for (std::size_t i = 0; i < sum.size(); ++i) result.append(sum[i]);
  }
  return result;
}

}  // namespace parmesan
