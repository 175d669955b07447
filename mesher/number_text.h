#pragma once

#include <string>

#include "mesher/geometry/point.h"

namespace parmesan {

/// Numbers and places as text, whatever the locale is: for doubles the shortest that reads back as the same, or with at
/// most so many significant digits, "1.23e-05"; "nan" has no sign.
std::string text(int value);
std::string text(double value);
std::string text(double value, int digits);
std::string text(const Point& p);  // "(x, y)"
std::string text(const Point& p, int digits);

/// The place to six digits, or, where coordinates exceed a thousand, to five decimals: "(0.333333, 0.5)".
std::string rounded_text(const Point& p);

}  // namespace parmesan
