#pragma once

#include <string>

#include "mesher/geometry/point.h"

namespace parmesan {

/// How messages write numbers and places: decimal, for doubles the shortest that reads back as the same.
std::string text(int value);
std::string text(double value);
std::string text(const Point& p);  // "(x, y)"

/// The place to six digits, or, where coordinates exceed a thousand, to five decimals: "(0.333333, 0.5)".
std::string rounded_text(const Point& p);

}  // namespace parmesan
