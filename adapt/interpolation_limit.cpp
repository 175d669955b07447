#include "adapt/interpolation_limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "mesher/geometry/symmetric_tensor.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

constexpr double tolerance = 3e-4;
constexpr std::size_t max_parts = 60'000;
constexpr std::size_t min_parts = 3000;         // of about equal size, to start from
constexpr double vanishing_determinant = 1e-8;  // |lambda_2 / lambda_1|, well above rounding
constexpr double unusable_share = 0.01;
constexpr double unusable_error = 0.05;

/// The integrals over a piece of the domain.
struct Integrals {
  double limit = 0.0;       // (kappa sqrt|det H|)^(2/3)
  double curvature = 0.0;   // |lambda_1|^(2/3)
  double degenerate = 0.0;  // the same where lambda_2 vanishes

  Integrals& operator+=(const Integrals& other) {
    limit += other.limit;
    curvature += other.curvature;
    degenerate += other.degenerate;
    return *this;
  }
};

struct Part {
  std::array<Point, 3> corner;
  Integrals sum;       // of its four quarters
  double error = 0.0;  // difference to the rule on the whole
};

Integrals integrand(const Expression& function, const Point& p) {
  const double kappa_positive = 2.0 / (3.0 * std::sqrt(5.0));
  const double kappa_negative = 1.0 / std::sqrt(90.0);
  const Jet u = function.jet(p);
  const SymmetricTensor h{u.xx, u.xy, u.yy};
  const double det = determinant(h);
  const Eigen2 e = eigen_decomposition(h);
  const double largest = std::max(std::abs(e.l1), std::abs(e.l2));
  if (!std::isfinite(det) || !std::isfinite(largest)) return {};
  const double kappa = det < 0.0 ? kappa_negative : kappa_positive;
  const double curvature = std::cbrt(largest * largest);
  const bool vanishes = std::abs(det) < vanishing_determinant * largest * largest;
  return {std::cbrt(kappa * kappa * std::abs(det)), curvature, vanishes ? curvature : 0.0};
}

// Dunavant's rule of degree 5 with 7 points, all inside (Int. J. Numer. Meth. Eng. 21, 1985).
Integrals integrate(const Expression& function, const std::array<Point, 3>& c) {
  static const double root15 = std::sqrt(15.0);
  static const std::array<double, 2> offset{(6.0 - root15) / 21.0, (6.0 + root15) / 21.0};
  static const std::array<double, 2> weight{(155.0 - root15) / 1200.0, (155.0 + root15) / 1200.0};
  const double area = 0.5 * doubled_area(c[0], c[1], c[2]);
  Integrals total;
  const auto add = [&](const Point& p, double w) {
    const Integrals at = integrand(function, p);
    total += {w * area * at.limit, w * area * at.curvature, w * area * at.degenerate};
  };
  const Point center = (1.0 / 3.0) * (c[0] + c[1] + c[2]);
  add(center, 9.0 / 40.0);
  for (std::size_t k = 0; k < 2; ++k)
    for (const Point& corner : c) add(3.0 * offset[k] * center + (1.0 - 3.0 * offset[k]) * corner, weight[k]);
  return total;
}

std::array<std::array<Point, 3>, 4> quarters(const std::array<Point, 3>& c) {
  const Point a = midpoint(c[1], c[2]);
  const Point b = midpoint(c[2], c[0]);
  const Point d = midpoint(c[0], c[1]);
  return {{{c[0], d, b}, {d, c[1], a}, {b, a, c[2]}, {a, b, d}}};
}

Part make_part(const Expression& function, const std::array<Point, 3>& corner) {
  Part part{corner, {}, 0.0};
  for (const auto& quarter : quarters(corner)) part.sum += integrate(function, quarter);
  part.error = std::abs(part.sum.limit - integrate(function, corner).limit);
  return part;
}

bool smaller_error(const Part& a, const Part& b) { return a.error < b.error; }

/// The integrals over all parts, and the sum of their errors.
struct Total {
  Integrals sum;
  double error = 0.0;
};

Total total_of(const std::vector<Part>& parts) {
  Total total;
  for (const Part& p : parts) {
    total.sum += p.sum;
    total.error += p.error;
  }
  return total;
}

std::vector<Part> initial_parts(const Mesh& mesh, const Expression& function) {
  std::vector<std::array<Point, 3>> pieces;
  for (const auto& [a, b, c] : mesh.triangles) {
    pieces.push_back({mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)]});
  }
  while (!pieces.empty() && pieces.size() < min_parts) {
    std::vector<std::array<Point, 3>> finer;
    finer.reserve(4 * pieces.size());
    for (const auto& piece : pieces)
      for (const auto& quarter : quarters(piece)) finer.push_back(quarter);
    pieces.swap(finer);
  }
  std::vector<Part> parts;
  parts.reserve(pieces.size());
  for (const auto& piece : pieces) parts.push_back(make_part(function, piece));
  return parts;
}

// Splits the part with the largest error until the sum of the errors is small.
Total refine(const Expression& function, std::vector<Part> heap) {
  std::ranges::make_heap(heap, smaller_error);
  Total total = total_of(heap);
  while (heap.size() < max_parts && total.error > tolerance * total.sum.limit) {
    std::ranges::pop_heap(heap, smaller_error);
    const Part worst = heap.back();
    heap.pop_back();
    total.error -= worst.error;
    total.sum.limit -= worst.sum.limit;
    for (const auto& quarter : quarters(worst.corner)) {
      heap.push_back(make_part(function, quarter));
      total.error += heap.back().error;
      total.sum.limit += heap.back().sum.limit;
      std::ranges::push_heap(heap, smaller_error);
    }
  }
  return total_of(heap);
}

}  // namespace

InterpolationLimit interpolation_limit(const Mesh& mesh, const Expression& function) {
  const auto [total, error] = refine(function, initial_parts(mesh, function));
  InterpolationLimit result;
  result.value = std::pow(total.limit, 1.5);
  result.relative_error = total.limit > 0.0 ? error / total.limit : 0.0;
  result.degenerate_share = total.curvature > 0.0 ? total.degenerate / total.curvature : 1.0;
  return result;
}

std::optional<double> efficiency(double l2_error, double num_triangles, const InterpolationLimit& limit) {
  const bool usable = limit.value > 0.0 && std::isfinite(limit.value) && limit.relative_error < unusable_error &&
                      limit.degenerate_share < unusable_share;
  if (!usable || !std::isfinite(l2_error)) return std::nullopt;
  return l2_error * num_triangles / limit.value;
}

}  // namespace parmesan
