#pragma once

#include <string>

namespace parmesan {

/// A colour of the perceptually even map viridis (S. van der Walt, N. Smith, 2015; CC0), from dark
/// blue at t = 0 over green to yellow at t = 1, as "#rrggbb". t is clamped to [0, 1].
std::string colour_at(double t);

}  // namespace parmesan
