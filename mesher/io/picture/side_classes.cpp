#include "mesher/io/picture/side_classes.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "mesher/index.h"

namespace parmesan {
namespace {

constexpr int smallest = -6;  // altitudes of sqrt(2)^-6 pixels
constexpr int largest = 6;

struct Side {
  int low;
  int high;
  int exponent;  // of its class
};

/// The triangle's smallest altitude, in pixels, as a power of the square root of 2.
int altitude_exponent(const Point& a, const Point& b, const Point& c) {
  const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
  const double altitude = longest > 0.0 ? std::abs(doubled_area(a, b, c)) / longest : 0.0;
  if (!(altitude > 0.0)) return smallest;
  return std::clamp(static_cast<int>(std::floor(2.0 * std::log2(altitude))), smallest, largest);
}

/// Each side once, with the smaller of its exponents, sorted by its end points.
std::vector<Side> sides_with_exponents(const Mesh& mesh, const View& view) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto corner = [&mesh, &view](int vertex) { return view(mesh.points[at(vertex)]); };
    const int exponent = altitude_exponent(corner(a), corner(b), corner(c));
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      sides.push_back({std::min(p, q), std::max(p, q), exponent});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return std::tie(s.low, s.high, s.exponent) < std::tie(t.low, t.high, t.exponent);
  });
  const auto same = [](const Side& s, const Side& t) { return s.low == t.low && s.high == t.high; };
  sides.erase(std::unique(sides.begin(), sides.end(), same), sides.end());
  return sides;
}

}  // namespace

std::vector<SideClass> side_classes(const Mesh& mesh, const View& view) {
  std::vector<SideClass> classes;
  for (int exponent = smallest; exponent <= largest; ++exponent) {
    classes.push_back({0.25 * std::exp2(0.25 * (exponent + 0.5)), {}});
  }
  for (const Side& side : sides_with_exponents(mesh, view)) {
    PicturePath& path = classes[at(side.exponent - smallest)].path;
    path.move_to(view(mesh.points[at(side.low)]));
    path.line_to(view(mesh.points[at(side.high)]));
  }
  std::erase_if(classes, [](const SideClass& c) { return c.path.empty(); });
  return classes;
}

}  // namespace parmesan
