#include "mesher/io/picture/ticks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace parmesan {
namespace {

std::string label(double value, std::chars_format format, int precision) {
  std::array<char, 64> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  return error == std::errc() ? std::string(buffer.data(), end) : "";
}

constexpr double tolerance = 1e-9;  // of a step, so that ticks at the ends are not lost to rounding

/// The ticks are k step with first <= k <= last.
struct Steps {
  double step;
  double first;
  double last;
};

Steps steps_of(double low, double high, double step) {
  return {step, std::ceil(low / step - tolerance), std::floor(high / step + tolerance)};
}

/// The smallest step of 1, 2, 5 times a power of ten with at most max_count ticks.
Steps nice_steps(double low, double high, int max_count) {
  const double power = std::pow(10.0, std::floor(std::log10((high - low) / max_count)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    const Steps steps = steps_of(low, high, factor * power);
    if (steps.last - steps.first < max_count) return steps;
  }
  return steps_of(low, high, 10.0 * power);
}

std::string tick_label(double value, double largest, double step) {
  const int step_exponent = static_cast<int>(std::floor(std::log10(step) + 1e-9));
  const int exponent = static_cast<int>(std::floor(std::log10(largest)));
  if (exponent < -3 || exponent > 5) return label(value, std::chars_format::general, exponent - step_exponent + 1);
  return label(value, std::chars_format::fixed, std::max(0, -step_exponent));
}

}  // namespace

std::vector<Tick> nice_ticks(double low, double high, int max_count) {
  const double largest = std::max(std::abs(low), std::abs(high));
  const double length = high - low;
  const double resolution = std::max(64.0 * std::numeric_limits<double>::epsilon() * largest, 1e-300);
  if (!(length > resolution) || !std::isfinite(length)) {
    return {{low, label(low, std::chars_format::general, 6)}};
  }
  const Steps steps = nice_steps(low, high, max_count);
  std::vector<Tick> ticks;
  const auto count = static_cast<int>(steps.last - steps.first) + 1;
  for (int i = 0; i < count; ++i) {
    const double k = steps.first + i;
    const double value = k == 0.0 ? 0.0 : k * steps.step;
    ticks.push_back({value, tick_label(value, largest, steps.step)});
  }
  return ticks;
}

}  // namespace parmesan
