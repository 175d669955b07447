#include "adapt/transfer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "mesher/errors.h"
#include "mesher/triangulation/neighbors.h"

namespace parmesan {
namespace {

struct Place {
  std::size_t triangle = 0;
  std::array<double, 3> weights{};
};

class Walker {
 public:
  explicit Walker(const Mesh& mesh) : mesh_(mesh), neighbors_(triangle_neighbors(mesh)) {}

  Place locate(const Point& p) {
    if (!walk(p)) here_ = nearest(p);
    return here_;
  }

 private:
  std::array<double, 3> weights(std::size_t triangle, const Point& p) const {
    const auto& t = mesh_.triangles[triangle];
    const Point& a = mesh_.points[static_cast<std::size_t>(t[0])];
    const Point& b = mesh_.points[static_cast<std::size_t>(t[1])];
    const Point& c = mesh_.points[static_cast<std::size_t>(t[2])];
    const double area = doubled_area(a, b, c);
    return {doubled_area(p, b, c) / area, doubled_area(a, p, c) / area, doubled_area(a, b, p) / area};
  }

  // Leaves through the side that has p farthest behind it; may cycle or end at the boundary.
  bool walk(const Point& p) {
    constexpr double slack = 1e-12;
    constexpr int max_steps = 5000;
    for (int step = 0; step < max_steps; ++step) {
      here_.weights = weights(here_.triangle, p);
      const auto worst = std::ranges::min_element(here_.weights);
      if (*worst >= -slack) return true;
      const int next = neighbors_[here_.triangle][static_cast<std::size_t>(worst - here_.weights.begin())];
      if (next < 0) return false;
      here_.triangle = static_cast<std::size_t>(next);
    }
    return false;
  }

  Place nearest(const Point& p) const {
    Place best;
    double best_distance = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Place place{t, clamped(weights(t, p))};
      Point foot;
      for (std::size_t k = 0; k < 3; ++k)
        foot = foot + place.weights[k] * mesh_.points[static_cast<std::size_t>(mesh_.triangles[t][k])];
      const double distance = squared_norm(foot - p);
      if (distance >= best_distance) continue;
      best_distance = distance;
      best = place;
    }
    return best;
  }

  static std::array<double, 3> clamped(std::array<double, 3> w) {
    double sum = 0.0;
    for (double& x : w) sum += x = std::max(x, 0.0);
    for (double& x : w) x /= sum;
    return w;
  }

  const Mesh& mesh_;
  std::vector<std::array<int, 3>> neighbors_;
  Place here_;
};

}  // namespace

std::vector<double> transfer(const Mesh& from, std::span<const double> values, const Mesh& to) {
  if (values.size() != from.points.size()) throw InputError("transfer needs one value per vertex");
  if (from.triangles.empty()) throw InputError("transfer needs a mesh with triangles");
  Walker walker(from);
  std::vector<double> result;
  result.reserve(to.points.size());
  for (const Point& p : to.points) {
    const Place place = walker.locate(p);
    double value = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      value += place.weights[k] * values[static_cast<std::size_t>(from.triangles[place.triangle][k])];
    result.push_back(value);
  }
  return result;
}

}  // namespace parmesan
