#include "mesher/io/picture/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace parmesan {
namespace {

using Rgb = std::array<int, 3>;

// viridis at t = 0, 1/8, ..., 1
constexpr std::array<Rgb, 9> control_points{{{68, 1, 84},
                                             {71, 45, 123},
                                             {59, 82, 139},
                                             {44, 114, 142},
                                             {33, 145, 140},
                                             {40, 174, 128},
                                             {94, 201, 98},
                                             {173, 220, 48},
                                             {253, 231, 37}}};

}  // namespace

std::string colour_at(double t) {
  constexpr char digits[] = "0123456789abcdef";
  const double place = std::clamp(t, 0.0, 1.0) * (control_points.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(place), control_points.size() - 2);
  const double weight = place - static_cast<double>(before);
  std::string colour = "#";
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double a = control_points[before][channel];
    const double b = control_points[before + 1][channel];
    const auto value = static_cast<std::size_t>(std::lround(a + weight * (b - a)));
    colour += digits[value / 16];
    colour += digits[value % 16];
  }
  return colour;
}

}  // namespace parmesan
