#include "mesher/io/triangle_rows.h"

#include <cmath>
#include <limits>

#include "mesher/index.h"

namespace parmesan {
namespace {

void require_more(TextReader& in, const char* what) {
  if (in.at_line_end()) in.fail(std::string("the line ends where ") + what + " should be");
}

}  // namespace

int integer_on_line(TextReader& in, const char* what) {
  require_more(in, what);
  return in.integer(what);
}

double real_on_line(TextReader& in, const char* what) {
  require_more(in, what);
  return in.real(what);
}

int index_on_line(TextReader& in, const char* what, const TriangleNodes& nodes) {
  require_more(in, what);
  return in.index(what, nodes.base, nodes.size());
}

int region_on_line(TextReader& in) {
  const double value = real_on_line(in, "the attribute of a region");
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
    in.fail("the attribute of a region must be a whole number within 32 bits");
  return static_cast<int>(value);
}

int integer_on_line_or(TextReader& in, const char* what, int absent) {
  return in.at_line_end() ? absent : in.integer(what);
}

void start_row(TextReader& in, int base, int i) {
  const int number = in.integer("the number of a row");
  if (number != base + i) {
    in.fail("the row has number " + std::to_string(number) + ", must be " + std::to_string(base + i));
  }
}

TriangleNodes read_triangle_nodes(TextReader& in) {
  TriangleNodes nodes;
  const int count = in.count("the number of vertices", 3);
  if (integer_on_line_or(in, "the dimension", 2) != 2) in.fail("the dimension must be 2");
  in.skip_line();
  nodes.points.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    if (i == 0) nodes.base = in.index("the number of the first vertex", 0, 2);
    if (i > 0) start_row(in, nodes.base, i);
    Point& point = nodes.points[at(i)];
    point.x = real_on_line(in, "the x coordinate");
    point.y = real_on_line(in, "the y coordinate");
    in.skip_line();
  }
  return nodes;
}

}  // namespace parmesan
