#pragma once

#include <string_view>

#include "mesher/geometry/point.h"
#include "mesher/io/output_file.h"

namespace parmesan {

/// A coordinate in pixels with two decimals, as short as possible. Beyond 10^12 pixels: clamped.
void write_pixels(OutputFile& out, double pixels);

/// A line in the current stroke.
void write_line(OutputFile& out, const Point& from, const Point& to);

/// A text; attributes: further ones of the <text> element, like text-anchor="end".
void write_text(OutputFile& out, const Point& at, std::string_view attributes, std::string_view text);

}  // namespace parmesan
