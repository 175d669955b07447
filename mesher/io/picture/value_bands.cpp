#include "mesher/io/picture/value_bands.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesher/errors.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// A corner of a polygon with its height, measured in bands from the lowest level.
struct Corner {
  Point point;
  double height = 0.0;
};

/// A convex polygon on the stack: a triangle cut twice has at most 5 corners.
struct Polygon {
  std::array<Corner, 8> corners;
  std::size_t size = 0;

  void add(const Corner& corner) { corners[size++] = corner; }
};

/// The part where sign * (height - level) >= 0 (Sutherland and Hodgman, 1974).
Polygon cut(const Polygon& polygon, double level, double sign) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Corner& a = polygon.corners[i];
    const Corner& b = polygon.corners[(i + 1) % polygon.size];
    const double from = sign * (a.height - level);
    const double to = sign * (b.height - level);
    if (from >= 0.0) result.add(a);
    if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0)) {
      result.add({lerp(a.point, b.point, from / (from - to)), level});
    }
  }
  return result;
}

void draw(PicturePath& path, const Polygon& polygon) {
  if (polygon.size < 3) return;
  path.move_to(polygon.corners[0].point);
  for (std::size_t i = 1; i < polygon.size; ++i) path.line_to(polygon.corners[i].point);
  path.close();
}

/// Cuts a triangle into its bands from below: each takes its slice off what is left.
void draw_slices(Polygon rest, std::vector<PicturePath>& bands) {
  const auto num_bands = static_cast<int>(bands.size());
  double lowest = rest.corners[0].height;
  double highest = lowest;
  for (std::size_t i = 1; i < rest.size; ++i) {
    lowest = std::min(lowest, rest.corners[i].height);
    highest = std::max(highest, rest.corners[i].height);
  }
  const int first = std::clamp(static_cast<int>(lowest), 0, num_bands - 1);
  const int last = std::clamp(static_cast<int>(std::ceil(highest)) - 1, first, num_bands - 1);
  for (int band = first; band < last; ++band) {
    draw(bands[at(band)], cut(rest, band + 1, -1.0));
    rest = cut(rest, band + 1, 1.0);
  }
  draw(bands[at(last)], rest);
}

}  // namespace

// Halves, because the difference of the ends may overflow.
double fraction(ValueRange range, double value) {
  const double half_length = 0.5 * range.high - 0.5 * range.low;
  return half_length > 0.0 ? (0.5 * value - 0.5 * range.low) / half_length : 0.5;
}

ValueRange range_of(std::span<const double> values) {
  if (values.empty()) return {};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  for (const double value : values) {
    if (!std::isfinite(value)) throw InputError("values that are not finite cannot be drawn");
  }
  return {*low, *high};
}

std::vector<PicturePath> value_bands(const Mesh& mesh, const View& view, std::span<const double> values,
                                     ValueRange range, int num_bands) {
  std::vector<PicturePath> bands(static_cast<std::size_t>(num_bands));
  for (const auto& triangle : mesh.triangles) {
    Polygon polygon;
    for (const int index : triangle) {
      const auto vertex = static_cast<std::size_t>(index);
      polygon.add({view(mesh.points[vertex]), fraction(range, values[vertex]) * num_bands});
    }
    draw_slices(polygon, bands);
  }
  return bands;
}

}  // namespace parmesan
