#include "adapt/absolute_hessian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "mesher/index.h"

namespace parmesan {
namespace {

bool is_finite(const SymmetricTensor& t) { return std::isfinite(t.xx) && std::isfinite(t.xy) && std::isfinite(t.yy); }

/// Running weighted mean of |H| and of the share of det H < 0 around one vertex.
struct PatchMean {
  SymmetricTensor sum;
  double weight = 0.0;
  double negative = 0.0;
  double sign_weight = 0.0;

  AbsoluteHessian mean() const {
    if (weight <= 0.0) return {};
    return {(1.0 / weight) * sum, sign_weight > 0.0 ? negative / sign_weight : 0.0};
  }
};

/// Calls visit(barycentric coordinates) at the three interior points (2/3, 1/6, 1/6) of each of the
/// n^2 congruent parts of a triangle. All weights are equal.
template <class Visit>
void for_each_sample(int n, Visit visit) {
  constexpr std::array<std::array<double, 2>, 3> rule{{{1.0 / 6, 1.0 / 6}, {2.0 / 3, 1.0 / 6}, {1.0 / 6, 2.0 / 3}}};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      for (const auto& [s, t] : rule) {
        visit(std::array<double, 2>{(i + s) / n, (j + t) / n});
        if (i + j < n - 1) visit(std::array<double, 2>{(i + 1 - s) / n, (j + 1 - t) / n});
      }
    }
  }
}

}  // namespace

SymmetricTensor absolute_value(const SymmetricTensor& hessian) {
  Eigen2 e = eigen_decomposition(hessian);
  e.l1 = std::abs(e.l1);
  e.l2 = std::abs(e.l2);
  return compose(e);
}

std::vector<double> vertex_areas(const Mesh& mesh) {
  std::vector<double> areas(mesh.points.size(), 0.0);
  for (const auto& t : mesh.triangles) {
    const std::array<std::size_t, 3> v{static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                                       static_cast<std::size_t>(t[2])};
    const double third = doubled_area(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]) / 6.0;
    for (const std::size_t k : v) areas[k] += third;
  }
  return areas;
}

std::vector<AbsoluteHessian> absolute_hessians(const Mesh& mesh, std::span<const Hessian> hessians) {
  const std::size_t n = hessians.size();
  const std::vector<double> areas = vertex_areas(mesh);
  std::vector<AbsoluteHessian> result(n);
  std::vector<double> weight(n, 0.0);
  std::vector<double> negative(n, 0.0);
  for (std::size_t v = 0; v < n; ++v) {
    const SymmetricTensor& h = hessians[v];
    if (!is_finite(h)) continue;
    result[v].tensor = absolute_value(h);
    const double det = determinant(h);
    weight[v] = areas[v] * std::cbrt(std::abs(det));
    negative[v] = det < 0.0 ? weight[v] : 0.0;
  }
  std::vector<double> patch_weight(n, 0.0);
  std::vector<double> patch_negative(n, 0.0);
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(t[k]);
      for (const int other : t) {
        patch_weight[v] += weight[at(other)];
        patch_negative[v] += negative[at(other)];
      }
    }
  }
  for (std::size_t v = 0; v < n; ++v)
    result[v].negative_share = patch_weight[v] > 0.0 ? patch_negative[v] / patch_weight[v] : 0.0;
  return result;
}

std::vector<AbsoluteHessian> exact_absolute_hessians(const Mesh& mesh, const Expression& function) {
  constexpr double samples_wanted = 3e5;
  const double per_triangle = samples_wanted / (3.0 * std::max(1, mesh.num_triangles()));
  const int n = std::clamp(static_cast<int>(std::sqrt(per_triangle)), 1, 16);
  std::vector<PatchMean> patches(mesh.points.size());
  for (const auto& t : mesh.triangles) {
    const Point& a = mesh.points[at(t[0])];
    const Point& b = mesh.points[at(t[1])];
    const Point& c = mesh.points[at(t[2])];
    const double area = doubled_area(a, b, c) / (6.0 * n * n);
    for_each_sample(n, [&](const std::array<double, 2>& s) {
      const Jet u = function.jet(a + s[0] * (b - a) + s[1] * (c - a));
      const SymmetricTensor h{u.xx, u.xy, u.yy};
      if (!is_finite(h)) return;
      const SymmetricTensor absolute = absolute_value(h);
      const double det = determinant(h);
      const std::array<double, 3> hat{1.0 - s[0] - s[1], s[0], s[1]};
      for (std::size_t k = 0; k < 3; ++k) {
        PatchMean& patch = patches[at(t[k])];
        const double w = area * hat[k];
        const double sign_weight = w * std::cbrt(std::abs(det));
        patch.sum = patch.sum + w * absolute;
        patch.weight += w;
        patch.sign_weight += sign_weight;
        if (det < 0.0) patch.negative += sign_weight;
      }
    });
  }
  std::vector<AbsoluteHessian> result;
  result.reserve(patches.size());
  for (const PatchMean& patch : patches) result.push_back(patch.mean());
  return result;
}

}  // namespace parmesan
