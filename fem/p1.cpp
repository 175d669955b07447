#include "fem/p1.h"

#include "mesher/errors.h"
#include "mesher/index.h"

namespace parmesan {

P1Element p1_element(const Mesh& mesh, int triangle) {
  const auto t = static_cast<std::size_t>(triangle);
  P1Element element;
  for (std::size_t i = 0; i < 3; ++i) element.p[i] = mesh.points[at(mesh.triangles[t][i])];
  const auto& [a, b, c] = element.p;
  const double doubled = doubled_area(a, b, c);
  if (!(doubled > 0.0))
    throw GeometryError("triangle " + std::to_string(triangle) + " has no positive area", {triangle});
  element.area = 0.5 * doubled;
  const auto turned = [doubled](const Vector& d) { return Vector{-d.y / doubled, d.x / doubled}; };
  element.gradient = {turned(c - b), turned(a - c), turned(b - a)};
  return element;
}

Vector p1_gradient(const P1Element& element, const std::array<double, 3>& values) {
  // Differences to the first value keep the digits of small gradients on large values.
  return (values[1] - values[0]) * element.gradient[1] + (values[2] - values[0]) * element.gradient[2];
}

}  // namespace parmesan
