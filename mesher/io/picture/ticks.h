#pragma once

#include <string>
#include <vector>

namespace parmesan {

/// A labelled place on an axis.
struct Tick {
  double value = 0.0;
  std::string label;
};

/// Between 2 and max_count ticks (max_count >= 5) in [low, high] at multiples of 1, 2 or 5 times a
/// power of ten, with as many decimals as the step needs; powers of ten for very large or small
/// numbers. One tick when low = high, or when the interval is below the resolution or beyond the
/// range of doubles.
std::vector<Tick> nice_ticks(double low, double high, int max_count);

}  // namespace parmesan
