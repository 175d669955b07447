#include "adapt/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace parmesan {

std::string short_number(double value, int digits) {
  if (std::isnan(value)) return "unknown";
  std::array<char, 64> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
  return std::string(buffer.data(), end.ptr);
}

std::string padded(const std::string& text, std::size_t width) {
  return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

}  // namespace parmesan
