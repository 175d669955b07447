#include "tests/oracle/big_integer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace parmesan::oracle {

namespace {

/// |value| = mantissa * 2^exponent with an odd mantissa; 0 for zero.
struct Binary {
  std::uint64_t mantissa;
  int exponent;
};

Binary decompose(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("not finite");
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
  const int field = static_cast<int>((bits >> 52) & 0x7FF);
  std::uint64_t mantissa = bits & 0xFFFFFFFFFFFFFULL;
  if (field != 0) mantissa |= 1ULL << 52;
  if (mantissa == 0) return {0, 0};
  const int zeros = std::countr_zero(mantissa);
  return {mantissa >> zeros, (field == 0 ? 1 : field) - 1075 + zeros};
}

}  // namespace

int common_shift(std::span<const double> values) {
  int lowest = 2000;
  for (const double v : values) {
    if (v != 0.0) lowest = std::min(lowest, decompose(v).exponent);
  }
  return lowest == 2000 ? 0 : -lowest;
}

void BigInteger::push_limb(std::uint32_t limb) {
  if (size_ == max_limbs) throw std::overflow_error("BigInteger");
  limbs_[size_++] = limb;
}

void BigInteger::drop_leading_zeros() {
  while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
}

BigInteger BigInteger::from_double(double value, int shift) {
  const Binary binary = decompose(value);
  BigInteger result;
  if (binary.mantissa == 0) return result;
  const int up = binary.exponent + shift;
  if (up < 0) throw std::invalid_argument("not an integer after the shift");
  for (int i = 0; i < up / 32; ++i) result.push_limb(0);
  const std::uint64_t low = (binary.mantissa & 0xFFFFFFFFULL) << (up % 32);
  const std::uint64_t middle = ((binary.mantissa >> 32) << (up % 32)) + (low >> 32);  // mantissa < 2^53
  result.push_limb(static_cast<std::uint32_t>(low));
  result.push_limb(static_cast<std::uint32_t>(middle));
  result.push_limb(static_cast<std::uint32_t>(middle >> 32));
  result.drop_leading_zeros();
  result.negative_ = std::signbit(value);
  return result;
}

int BigInteger::compare_magnitude(const BigInteger& a, const BigInteger& b) {
  if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
  for (int i = a.size_ - 1; i >= 0; --i) {
    if (a.limbs_[i] != b.limbs_[i]) return a.limbs_[i] < b.limbs_[i] ? -1 : 1;
  }
  return 0;
}

BigInteger BigInteger::add_magnitude(const BigInteger& a, const BigInteger& b) {
  BigInteger result;
  std::uint64_t carry = 0;
  for (int i = 0; i < std::max(a.size_, b.size_) || carry != 0; ++i) {
    carry += (i < a.size_ ? a.limbs_[i] : 0ULL) + (i < b.size_ ? b.limbs_[i] : 0ULL);
    result.push_limb(static_cast<std::uint32_t>(carry));
    carry >>= 32;
  }
  return result;
}

BigInteger BigInteger::subtract_magnitude(const BigInteger& a, const BigInteger& b) {
  BigInteger result;
  std::int64_t borrow = 0;
  for (int i = 0; i < a.size_; ++i) {
    const std::int64_t difference =
        static_cast<std::int64_t>(a.limbs_[i]) - (i < b.size_ ? static_cast<std::int64_t>(b.limbs_[i]) : 0) - borrow;
    borrow = difference < 0 ? 1 : 0;
    result.push_limb(static_cast<std::uint32_t>(difference + (borrow << 32)));
  }
  result.drop_leading_zeros();
  return result;
}

BigInteger BigInteger::add_signed(const BigInteger& a, const BigInteger& b, bool b_negative) {
  if (a.negative_ == b_negative) {
    BigInteger result = add_magnitude(a, b);
    result.negative_ = b_negative;
    return result;
  }
  const bool a_larger = compare_magnitude(a, b) >= 0;
  BigInteger result = a_larger ? subtract_magnitude(a, b) : subtract_magnitude(b, a);
  result.negative_ = result.size_ > 0 && (a_larger ? a.negative_ : b_negative);
  return result;
}

BigInteger operator+(const BigInteger& a, const BigInteger& b) { return BigInteger::add_signed(a, b, b.negative_); }

BigInteger operator-(const BigInteger& a, const BigInteger& b) {
  if (b.size_ == 0) return a;
  if (a.size_ == 0) {
    BigInteger result = b;
    result.negative_ = !b.negative_;
    return result;
  }
  return BigInteger::add_signed(a, b, !b.negative_);
}

BigInteger operator*(const BigInteger& a, const BigInteger& b) {
  BigInteger result;
  if (a.size_ == 0 || b.size_ == 0) return result;
  for (int i = 0; i < a.size_ + b.size_; ++i) result.push_limb(0);
  for (int i = 0; i < a.size_; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < b.size_; ++j) {
      carry += static_cast<std::uint64_t>(a.limbs_[i]) * b.limbs_[j] + result.limbs_[i + j];
      result.limbs_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    result.limbs_[i + b.size_] = static_cast<std::uint32_t>(carry);
  }
  result.drop_leading_zeros();
  result.negative_ = a.negative_ != b.negative_;
  return result;
}

}  // namespace parmesan::oracle
