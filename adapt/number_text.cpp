#include "adapt/number_text.h"

#include <cmath>

#include "mesher/number_text.h"

namespace parmesan {

std::string short_number(double value, int digits) { return std::isnan(value) ? "unknown" : text(value, digits); }

std::string padded(const std::string& text, std::size_t width) {
  return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

}  // namespace parmesan
