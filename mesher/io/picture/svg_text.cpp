#include "mesher/io/picture/svg_text.h"

#include <algorithm>
#include <cmath>

#include "mesher/io/xml_text.h"

namespace parmesan {

void write_pixels(OutputFile& out, double pixels) {
  out << std::round(100.0 * std::clamp(pixels, -1e12, 1e12)) / 100.0;
}

void write_line(OutputFile& out, const Point& from, const Point& to) {
  out << "<path d=\"M";
  write_pixels(out, from.x);
  out << ' ';
  write_pixels(out, from.y);
  out << 'L';
  write_pixels(out, to.x);
  out << ' ';
  write_pixels(out, to.y);
  out << "\"/>\n";
}

void write_text(OutputFile& out, const Point& at, std::string_view attributes, std::string_view text) {
  out << "<text x=\"";
  write_pixels(out, at.x);
  out << "\" y=\"";
  write_pixels(out, at.y);
  out << '"' << (attributes.empty() ? "" : " ") << attributes << '>' << xml_escaped(text) << "</text>\n";
}

}  // namespace parmesan
