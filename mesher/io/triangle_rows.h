#pragma once

#include <string>
#include <vector>

#include "mesher/geometry/point.h"
#include "mesher/io/text.h"

namespace parmesan {

/// The vertices of a file of Triangle and the number of the first one, 0 or 1.
struct TriangleNodes {
  std::vector<Point> points;
  int base = 1;

  int size() const { return static_cast<int>(points.size()); }
};

/// A number that must stand on the line that has been begun. Errors: FileError.
int integer_on_line(TextReader& in, const char* what);
double real_on_line(TextReader& in, const char* what);
int index_on_line(TextReader& in, const char* what, const TriangleNodes& nodes);

/// The number of a region: an attribute, real in Triangle's files, that must be whole. Errors: FileError.
int region_on_line(TextReader& in);

/// The same, or the value for an absent one when the line ends.
int integer_on_line_or(TextReader& in, const char* what, int absent);

/// Begins row i of a list: reads its number, which must be base + i. Errors: FileError.
void start_row(TextReader& in, int base, int i);

/// Reads a list of vertices: number, dimension, attributes, markers; then i x y and what is skipped.
/// Errors: FileError.
TriangleNodes read_triangle_nodes(TextReader& in);

}  // namespace parmesan
