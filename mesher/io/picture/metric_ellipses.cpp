#include "mesher/io/picture/metric_ellipses.h"

#include <cmath>
#include <numbers>

namespace parmesan {
namespace {

// M = L L^T, so that |L^T d| is the metric length of d.
Vector on_unit_circle_of(const Metric& metric, double angle) {
  const SymmetricTensor& m = metric.tensor();
  const double l11 = std::sqrt(m.xx);
  const double l21 = m.xy / l11;
  const double l22 = std::sqrt(m.yy - l21 * l21);
  const double y = std::sin(angle) / l22;
  return {(std::cos(angle) - l21 * y) / l11, y};
}

}  // namespace

PicturePath metric_ellipses(const Mesh& mesh, const View& view, std::span<const Metric> metrics) {
  constexpr std::size_t most = 2000;
  constexpr int corners = 72;
  const std::size_t stride = (metrics.size() + most - 1) / most;
  PicturePath path;
  for (std::size_t v = 0; v < metrics.size(); v += stride) {
    for (int i = 0; i < corners; ++i) {
      const Point place =
          view(mesh.points[v] + 0.5 * on_unit_circle_of(metrics[v], 2.0 * std::numbers::pi * i / corners));
      if (i == 0)
        path.move_to(place);
      else
        path.line_to(place);
    }
    path.close();
  }
  return path;
}

}  // namespace parmesan
