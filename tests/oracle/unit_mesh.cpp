#include "tests/oracle/unit_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

namespace parmesan::oracle {

namespace {

using Tensor = std::array<double, 3>;

double squared_length(const Tensor& m, const Point& a, const Point& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  return m[0] * dx * dx + 2.0 * m[1] * dx * dy + m[2] * dy * dy;
}

// Near la = lb the quotient is 0 / 0; there the mean of the two differs by O((la - lb)^2).
double length(const Tensor& ma, const Tensor& mb, const Point& a, const Point& b) {
  const double la = std::sqrt(squared_length(ma, a, b));
  const double lb = std::sqrt(squared_length(mb, a, b));
  if (std::abs(la - lb) < 1e-6 * la) return 0.5 * (la + lb);
  return (la - lb) / std::log(la / lb);
}

double det(const Tensor& m) { return m[0] * m[2] - m[1] * m[1]; }

double quality(const std::array<Point, 3>& p, const std::array<Tensor, 3>& tensors) {
  const Tensor& m = *std::max_element(tensors.begin(), tensors.end(),
                                      [](const Tensor& a, const Tensor& b) { return det(a) < det(b); });
  const double area = 0.5 * ((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x));
  const double lengths = squared_length(m, p[0], p[1]) + squared_length(m, p[1], p[2]) + squared_length(m, p[2], p[0]);
  return 4.0 * std::numbers::sqrt3 * area * std::sqrt(det(m)) / lengths;
}

class Measures {
 public:
  Measures(const Mesh& mesh, const ExactMetric& metric) : mesh_(mesh) {
    for (const Point& p : mesh.points) tensors_.push_back(metric(p));
  }

  UnitMesh of_edges_and_triangles() const {
    UnitMesh result;
    measure_edges(result);
    measure_triangles(result);
    return result;
  }

 private:
  const Point& point(int v) const { return mesh_.points.at(static_cast<std::size_t>(v)); }
  const Tensor& tensor(int v) const { return tensors_.at(static_cast<std::size_t>(v)); }

  std::set<std::array<int, 2>> edges() const {
    std::set<std::array<int, 2>> all;
    for (const auto& [a, b, c] : mesh_.triangles)
      for (const auto& [i, j] : {std::array{a, b}, std::array{b, c}, std::array{c, a}})
        all.insert({std::min(i, j), std::max(i, j)});
    return all;
  }

  void measure_edges(UnitMesh& result) const {
    result.length_min = std::numeric_limits<double>::infinity();
    int num_unit = 0;
    int num_edges = 0;
    for (const auto& edge : edges()) {
      const double l = length(tensor(edge[0]), tensor(edge[1]), point(edge[0]), point(edge[1]));
      ++num_edges;
      num_unit += l * l >= 0.5 && l * l <= 2.0;
      if (l < result.length_min) {
        result.length_min = l;
        result.shortest_edge = edge;
      }
      if (!(l <= result.length_max)) {  // a length that is not a number shows up as the longest
        result.length_max = l;
        result.longest_edge = edge;
      }
    }
    result.unit_edges = static_cast<double>(num_unit) / num_edges;
  }

  void measure_triangles(UnitMesh& result) const {
    result.quality_min = std::numeric_limits<double>::infinity();
    double sum = 0.0;
    for (int t = 0; t < mesh_.num_triangles(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[static_cast<std::size_t>(t)];
      const double q = quality({point(a), point(b), point(c)}, {tensor(a), tensor(b), tensor(c)});
      sum += q;
      if (q < result.quality_min) {
        result.quality_min = q;
        result.worst_triangle = t;
      }
    }
    result.quality_mean = sum / mesh_.num_triangles();
  }

  const Mesh& mesh_;
  std::vector<Tensor> tensors_;
};

}  // namespace

UnitMesh unit_mesh(const Mesh& mesh, const ExactMetric& metric) {
  return Measures(mesh, metric).of_edges_and_triangles();
}

}  // namespace parmesan::oracle
