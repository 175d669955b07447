#include "mesher/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace parmesan {
namespace {

template <class... Format>
std::string written(double value, Format... format) {
  if (std::isnan(value)) return "nan";
  std::array<char, 64> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...).ptr};
}

}  // namespace

std::string text(int value) { return std::to_string(value); }

std::string text(double value) { return written(value); }

std::string text(double value, int digits) { return written(value, std::chars_format::general, digits); }

std::string text(const Point& p) { return "(" + text(p.x) + ", " + text(p.y) + ")"; }

std::string text(const Point& p, int digits) { return "(" + text(p.x, digits) + ", " + text(p.y, digits) + ")"; }

std::string rounded_text(const Point& p) {
  const double largest = std::max(std::abs(p.x), std::abs(p.y));
  return text(p, largest > 1e3 ? 6 + static_cast<int>(std::min(11.0, std::log10(largest))) : 6);
}

}  // namespace parmesan
