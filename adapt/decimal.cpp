#include "adapt/decimal.h"

#include <array>
#include <charconv>
#include <cmath>

namespace parmesan {

std::string decimal(double value) {
  if (std::isnan(value)) return "nan";
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

}  // namespace parmesan
