#include "tools/thesis/gaussian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fem/quadrature.h"
#include "mesher/index.h"

namespace parmesan::thesis {
namespace {

// Of the eigenvalues; the largest is 1, at the center. The thesis says no number. The metric for L2 is raised where the
// determinant is small and needs a lower one: measured at 16 000 particles, 2.97 with 0.01, 3.07 with 0.001.
constexpr double floor_as_written = 0.01;
constexpr double floor_for_l2 = 0.001;

struct GaussianHessian {
  Eigen2 absolute;
  bool is_negative = false;  // det H < 0
};

GaussianHessian hessian_at(const Point& p, const Point& center, double floor) {
  const Vector d = p - center;
  const double f = gaussian_at(p, center);
  Eigen2 e = eigen_decomposition({(d.x * d.x - 1.0) * f, d.x * d.y * f, (d.y * d.y - 1.0) * f});
  const bool is_negative = e.l1 * e.l2 < 0.0;
  e.l1 = std::max(std::abs(e.l1), floor);
  e.l2 = std::max(std::abs(e.l2), floor);
  return {e, is_negative};
}

// Of a triangle cut into four.
double squared_error(const std::array<Point, 3>& corner) {
  const std::array<Point, 3> middle{midpoint(corner[1], corner[2]), midpoint(corner[2], corner[0]),
                                    midpoint(corner[0], corner[1])};
  const std::array<std::array<Point, 3>, 4> parts{{{corner[0], middle[2], middle[1]},
                                                   {middle[2], corner[1], middle[0]},
                                                   {middle[1], middle[0], corner[2]},
                                                   {middle[0], middle[1], middle[2]}}};
  const std::array<double, 3> f{gaussian_at(corner[0]), gaussian_at(corner[1]), gaussian_at(corner[2])};
  const double whole = doubled_area(corner[0], corner[1], corner[2]);
  const auto interpolant = [&](const Point& p) {
    return (f[0] * doubled_area(p, corner[1], corner[2]) + f[1] * doubled_area(corner[0], p, corner[2]) +
            f[2] * doubled_area(corner[0], corner[1], p)) /
           whole;
  };
  double sum = 0.0;
  for (const auto& t : parts) {
    for (const TrianglePoint& q : degree6_rule()) {
      const Point p = q.lambda[0] * t[0] + q.lambda[1] * t[1] + q.lambda[2] * t[2];
      const double error = gaussian_at(p) - interpolant(p);
      sum += 0.125 * whole * q.weight * error * error;
    }
  }
  return sum;
}

}  // namespace

double gaussian_at(const Point& p, const Point& center) { return std::exp(-0.5 * squared_norm(p - center)); }

std::unique_ptr<MetricField> metric_of_thesis(double factor, const Point& center) {
  return std::make_unique<CallableField>([factor, center](const Point& p) {
    return Metric::from_tensor(factor * compose(hessian_at(p, center, floor_as_written).absolute));
  });
}

std::unique_ptr<MetricField> metric_for_l2(double factor) {
  return std::make_unique<CallableField>([factor](const Point& p) {
    const GaussianHessian h = hessian_at(p, {}, floor_for_l2);
    const double scale = std::pow(h.absolute.l1 * h.absolute.l2, -1.0 / 6.0) * (h.is_negative ? 0.5 : 1.0);
    return Metric::from_tensor(factor * scale * compose(h.absolute));
  });
}

double interpolation_error(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += squared_error({mesh.points[at(t[0])], mesh.points[at(t[1])], mesh.points[at(t[2])]});
  return std::sqrt(sum);
}

Run run_for_vertices(const Domain& domain, const std::function<std::unique_ptr<MetricField>(double)>& family,
                     double vertices, const GenerateOptions& options) {
  constexpr int max_tries = 8;
  double factor = vertices;
  Run best;
  for (int i = 0; i < max_tries; ++i) {
    Run made = run(domain, *family(factor), options);
    const double ratio = vertices / made.vertices();
    const auto miss = [&](const Run& r) { return std::abs(std::log(vertices / r.vertices())); };
    if (best.mesh.points.empty() || miss(made) < miss(best)) best = std::move(made);
    if (miss(best) < 0.005) break;
    factor *= ratio;
  }
  return best;
}

namespace {

std::unique_ptr<MetricField> uniform(double factor) {
  return std::make_unique<ConstantField>(Metric::isotropic(1.0 / std::sqrt(factor)));
}

/// The error times the number of triangles, which does not depend on it once the mesh resolves the function.
double scaled_error(const Run& made) { return interpolation_error(made.mesh) * made.triangles(); }

/// The same for equilateral triangles of one size, many of them: with edges e of length h and d = e.H e, the square of
/// the error on a triangle T is |T| ((sum d)^2 + sum d^2)/720, sum d = 3/2 h^2 tr H, and as three directions 60 degrees
/// apart average quartics like a circle, sum d^2 = 3/8 h^4 (2 H:H + (tr H)^2). By midpoints on 300 x 300 cells.
double scaled_error_of_equilateral_triangles(double side) {
  constexpr int cells = 300;
  const double width = side / cells;
  double sum = 0.0;
  for (int i = 0; i < cells * cells; ++i) {
    const int column = i % cells;
    const int row = i / cells;
    const Point p{width * (column + 0.5), width * (row + 0.5)};
    const double f = gaussian_at(p);
    const double xx = (p.x * p.x - 1.0) * f, xy = p.x * p.y * f, yy = (p.y * p.y - 1.0) * f;
    const double trace = xx + yy;
    const double squares = xx * xx + 2.0 * xy * xy + yy * yy;
    sum += 2.25 * trace * trace + 0.375 * (2.0 * squares + trace * trace);
  }
  const double of_unit_edges = std::sqrt(width * width * sum / 720.0);  // h = 1: error / h^2
  return of_unit_edges * side * side * 4.0 / std::numbers::sqrt3;       // triangles = area / (sqrt3/4 h^2)
}

}  // namespace

Item gaussian(const Setting& setting) {
  Item item("gaussian", "Fig. 5.2 and 5.6.1: meshes for the Gaussian on [0, 3] x [0, 3]");
  const Domain domain = rectangle(3, 3);
  const auto of_thesis = [](double factor) { return metric_of_thesis(factor); };
  const Run unadapted = run_for_vertices(domain, uniform, 572, as_written());
  const Run adapted = run_for_vertices(domain, of_thesis, 409, as_written());
  const Run fast = run_for_vertices(domain, metric_for_l2, 409, {});
  GenerateOptions options;
  const Run many = run_for_vertices(domain, metric_for_l2, setting.quick ? 4000 : 16000, options);
  const Run many_uniform = run_for_vertices(domain, uniform, setting.quick ? 4000 : 16000, options);
  const std::vector<std::pair<std::string, const Run*>> all{
      {"unadapted", &unadapted}, {"adapted", &adapted}, {"ours", &fast}};
  for (const auto& [name, made] : all) {
    draw(setting, "fig_5_2_" + name + ".svg", made->mesh);
    item.add_picture("fig_5_2_" + name + ".svg",
                     name + ": " + std::to_string(made->mesh.num_vertices()) + " particles");
  }
  const double rms = scaled_error(unadapted) / scaled_error(adapted);
  const double ours = scaled_error(unadapted) / scaled_error(fast);
  const double ours_many = scaled_error(many_uniform) / scaled_error(many);
  const std::string reading =
      "theory allows 3.18 at most for RMS, and our mean square ratio is near 8: that is the likely reading";
  item.add("RMS error, unadapted over adapted, equal triangles, thesis's metric", 8, rms, reading,
           {.min = 2.4, .max = 3.0});
  item.add("mean square error, the same", 8, rms * rms, reading);
  item.add("RMS ratio at 409 particles, our metric and schedule", 8, ours, reading, {.min = 2.9});
  item.add("RMS ratio at " + std::to_string(many.mesh.num_vertices()) + " particles, our metric and schedule", 8,
           ours_many, reading, {.min = setting.quick ? 2.9 : 3.05});
  item.add(
      "the same against equilateral triangles of one size, by theory", nullptr,
      scaled_error_of_equilateral_triangles(3.0) / scaled_error(many),
      "theory's 3.18 is against equilateral triangles; meshes of one size made from scratch have 5 - 7 % more error",
      {.max = 3.18});
  item.add("unit edges as written, adapted, %", nullptr, 100.0 * adapted.quality.unit_edges);
  item.add("mean quality as written, adapted", nullptr, adapted.quality.quality_mean);
  item.add("settled, adapted (1) or not (0)", 1, adapted.report->settled ? 1.0 : 0.0, "", {.min = 1.0});
  item.add_note(
      "Errors are compared at equal numbers of triangles: each is multiplied by its mesh's number. Eigenvalues "
      "are at least 0.01 of the largest (0.001 in our metric); the thesis limits them without saying to what.");
  return item;
}

}  // namespace parmesan::thesis
