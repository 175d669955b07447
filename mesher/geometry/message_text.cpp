#include "mesher/geometry/message_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace parmesan {

std::string text(int value) { return std::to_string(value); }

std::string text(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string text(const Point& p) { return "(" + text(p.x) + ", " + text(p.y) + ")"; }

std::string rounded_text(const Point& p) {
  const double largest = std::max(std::abs(p.x), std::abs(p.y));
  const int digits = largest > 1e3 ? 6 + static_cast<int>(std::min(11.0, std::log10(largest))) : 6;
  const auto rounded = [digits](double x) {
    std::array<char, 32> buffer;
    const auto general = std::chars_format::general;
    return std::string(buffer.data(),
                       std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, general, digits).ptr);
  };
  return "(" + rounded(p.x) + ", " + rounded(p.y) + ")";
}

}  // namespace parmesan
