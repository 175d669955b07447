#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace parmesan::oracle {

/// A signed integer of up to 2048 bits: sign and magnitude, schoolbook arithmetic.
///
/// Errors: std::overflow_error when a result needs more bits.
class BigInteger {
 public:
  BigInteger() = default;

  /// value * 2^shift, which must be an integer. Errors: std::invalid_argument when it is not.
  static BigInteger from_double(double value, int shift);

  /// -1, 0 or 1.
  int sign() const { return size_ == 0 ? 0 : (negative_ ? -1 : 1); }

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b);

 private:
  static constexpr int max_limbs = 64;

  static int compare_magnitude(const BigInteger& a, const BigInteger& b);
  static BigInteger add_magnitude(const BigInteger& a, const BigInteger& b);
  static BigInteger subtract_magnitude(const BigInteger& a, const BigInteger& b);
  static BigInteger add_signed(const BigInteger& a, const BigInteger& b, bool b_negative);
  void push_limb(std::uint32_t limb);
  void drop_leading_zeros();

  std::uint32_t limbs_[max_limbs];  // of which the first size_ are set, least significant first
  int size_ = 0;
  bool negative_ = false;
};

/// The smallest shift that makes every value * 2^shift an integer.
int common_shift(std::span<const double> values);

}  // namespace parmesan::oracle
