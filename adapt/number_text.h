#pragma once

#include <cstddef>
#include <string>

namespace parmesan {

/// A number with at most so many significant digits, independent of the locale: "1.23e-05", "0.5"; "unknown" for NaN.
std::string short_number(double value, int digits = 4);

/// Text moved to the right end of a field of this width.
std::string padded(const std::string& text, std::size_t width);

}  // namespace parmesan
