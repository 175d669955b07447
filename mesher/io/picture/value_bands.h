#pragma once

#include <span>
#include <vector>

#include "mesher/io/picture/picture_path.h"
#include "mesher/io/picture/view.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The range of values in a picture.
struct ValueRange {
  double low = 0.0;
  double high = 0.0;
};

/// Where the value lies in the range: 0 at its low end, 1 at its high end; 1/2 when these are equal.
double fraction(ValueRange range, double value);

/// The smallest and the largest value. Errors: InputError for values that are not finite.
ValueRange range_of(std::span<const double> values);

/// Where the piecewise linear function with these values at the vertices lies in each of num_bands
/// equal parts of the range: a path of polygons per band, the lowest first. Each triangle is cut
/// exactly along the levels. Cost: O(triangles x bands that they cross).
std::vector<PicturePath> value_bands(const Mesh& mesh, const View& view, std::span<const double> values,
                                     ValueRange range, int num_bands);

}  // namespace parmesan
