#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "mesher/geometry/expansion.h"

namespace parmesan {

__extension__ using Int128 = __int128;
__extension__ using UnsignedInt128 = unsigned __int128;

/// An exact difference of doubles, value + error.
inline ExactPair difference(double a, double b) { return two_sum(a, -b); }

/// Exact differences as integers under 2^60 of a common unit, a power of two; nothing when they have
/// no such unit, or one over 1 or so small that scaling could overflow.
///
/// Neighbours in a mesh normally have one: their differences have fewer bits than their coordinates.
template <std::size_t N>
std::optional<std::array<std::int64_t, N>> in_fixed_point(const std::array<ExactPair, N>& differences) {
  double largest = 0.0;
  for (const ExactPair& d : differences) largest = std::max(largest, std::abs(d.value));
  constexpr int bits = 60;
  constexpr int bias = 1023;
  const int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> 52U) - bias;
  const int shift = bits - 1 - exponent;
  if (shift < 0 || shift > 1000) return std::nullopt;
  const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(shift + bias) << 52U);
  std::array<std::int64_t, N> result;
  bool is_exact = true;
  for (std::size_t i = 0; i < N; ++i) {
    const double value = scale * differences[i].value;
    const double error = scale * differences[i].error;
    const auto whole = static_cast<std::int64_t>(value);
    const auto rest = static_cast<std::int64_t>(error);
    is_exact = is_exact && static_cast<double>(whole) == value && static_cast<double>(rest) == error;
    result[i] = whole + rest;
  }
  if (!is_exact) return std::nullopt;
  return result;
}

/// A sum of products of 128-bit integers under 2^122, four terms at most.
///
/// The sum is high 2^128 + middle 2^64 + low.
class WideSum {
 public:
  void add_product(Int128 a, Int128 b) {
    const auto a_high = static_cast<std::int64_t>(a >> 64);
    const auto b_high = static_cast<std::int64_t>(b >> 64);
    const auto a_low = static_cast<std::uint64_t>(a);
    const auto b_low = static_cast<std::uint64_t>(b);
    const UnsignedInt128 lowest = UnsignedInt128{a_low} * b_low;
    high_ += Int128{a_high} * b_high;
    middle_ += Int128{a_high} * b_low + Int128{b_high} * a_low + static_cast<std::uint64_t>(lowest >> 64U);
    low_ += static_cast<std::uint64_t>(lowest);
  }

  int sign() const {
    const Int128 middle = middle_ + static_cast<Int128>(low_ >> 64U);
    const Int128 high = high_ + (middle >> 64);
    if (high != 0) return high < 0 ? -1 : 1;
    return static_cast<std::uint64_t>(middle) != 0 || static_cast<std::uint64_t>(low_) != 0 ? 1 : 0;
  }

 private:
  Int128 high_ = 0;
  Int128 middle_ = 0;
  UnsignedInt128 low_ = 0;
};

}  // namespace parmesan
