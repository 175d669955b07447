#include <cmath>

#include "mesher/metric/metric_samples.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/delaunay.h"
#include "tools/thesis/gaussian.h"

namespace parmesan::thesis {
namespace {

/// Metrics sampled by hand: a curved shock that needs the size h across it, and a wake behind a corner.
struct Samples {
  std::vector<Point> points;
  std::vector<Metric> metrics;
};

Samples hand_made_samples(double across, double along, double far) {
  Samples samples;
  const auto add = [&](const Point& p, double h1, double h2, double angle) {
    samples.points.push_back(p);
    samples.metrics.push_back(Metric::from_sizes(h1, h2, angle));
  };
  for (const Point& p : {Point{0, 0}, Point{2, 0}, Point{2, 1}, Point{0, 1}, Point{0.5, 0}, Point{1.6, 1}})
    add(p, far, far, 0.0);
  for (int i = 0; i <= 6; ++i) {
    const double y = i / 6.0;
    const double x = 0.8 + 0.5 * y * y;
    const double angle = std::atan2(1.0, y);
    const Vector normal{std::sin(angle), -std::cos(angle)};
    add({x, y}, along, across, angle);
    for (const double offset : {-0.25, 0.25}) {
      const Point p = Point{x, y} + offset * normal;
      if (p.x >= 0.0 && p.x <= 2.0 && p.y >= 0.0 && p.y <= 1.0) add(p, far, far, angle);
    }
  }
  return samples;
}

Mesh triangulated(const std::vector<Point>& points) { return to_mesh(delaunay(points).triangulation, {}).mesh; }

}  // namespace

Item background_mesh(const Setting& setting) {
  Item item("background", "Figs 5.3 - 5.5: a hand-made background mesh");
  const double across = setting.quick ? 0.06 : 0.0284;
  const Samples samples = hand_made_samples(across, 0.16, 0.19);
  const BackgroundMesh linear = background_of_samples(samples.points, samples.metrics, MetricInterpolation::Linear);
  const BackgroundMesh log_euclidean = background_of_samples(samples.points, samples.metrics);
  const Domain channel = rectangle(2, 1);
  const Run uniform = run(channel, ConstantField(Metric::isotropic(across)), as_written());
  const Run anisotropic = run(channel, linear, as_written());
  const Run with_logs = run(channel, log_euclidean, as_written());
  draw(setting, "fig_5_3.svg", uniform.mesh);
  draw(setting, "fig_5_4.svg", anisotropic.mesh);
  draw(setting, "fig_5_5.svg", triangulated(samples.points));
  item.add_picture("fig_5_3.svg", "uniform: " + std::to_string(uniform.mesh.num_vertices()) + " particles");
  item.add_picture("fig_5_4.svg", "anisotropic: " + std::to_string(anisotropic.mesh.num_vertices()) + " particles");
  item.add_picture("fig_5_5.svg", "background mesh: " + std::to_string(samples.points.size()) + " samples");
  const std::string why =
      "domain and background mesh are not given: ours asks for the uniform size across a curved shock";
  item.add("particles, uniform", 2865, uniform.vertices(), why);
  item.add("particles, anisotropic", 229, anisotropic.vertices(), why);
  item.add("uniform over anisotropic", 12.5, uniform.vertices() / anisotropic.vertices(), why,
           {.min = setting.quick ? 2.0 : 6.0});
  item.add("anisotropic, log-Euclidean interpolation instead of linear", nullptr, with_logs.vertices(),
           "linear interpolation (5.17) lets the small size reach farther: more particles",
           {.max = anisotropic.vertices()});
  item.add("unit edges, anisotropic, %", nullptr, 100.0 * anisotropic.quality.unit_edges);
  item.add("mean quality, anisotropic", nullptr, anisotropic.quality.quality_mean);
  return item;
}

Item forces(const Setting& setting) {
  Item item("forces", "Forces 5.15 (gradient) and 5.16 (along the edge)");
  const Domain domain = rectangle(3, 3);
  std::vector<std::vector<Json>> rows;
  std::array<double, 2> quality{};
  std::array<double, 2> settled{};
  const int runs = setting.quick ? 1 : 3;
  for (const auto& [name, force] : force_names) {
    const std::size_t k = force == Force::Gradient ? 0 : 1;
    for (int seed = 1; seed <= runs; ++seed) {
      ParticleOptions thesis{.force = force};
      thesis.max_picks = setting.quick ? 100.0 : 200.0;
      const Run made = run(domain, *metric_of_thesis(setting.quick ? 150.0 : 400.0),
                           as_written(thesis, static_cast<std::uint64_t>(seed)));
      rows.push_back({std::string(name), seed, made.vertices(), made.quality.quality_mean, made.quality.quality_min,
                      100.0 * made.quality.unit_edges, made.picks_per_particle(), made.report->settled ? "yes" : "no"});
      quality[k] += made.quality.quality_mean / runs;
      settled[k] += made.report->settled ? 1.0 / runs : 0.0;
    }
  }
  item.add_table(
      "The Gaussian of 5.6.1",
      {"force", "seed", "particles", "mean quality", "lowest", "unit edges, %", "picks per particle", "settled"}, rows);
  item.add("share of runs with 5.15 that settle", nullptr, settled[0],
           "5.15 turns edges towards the eigenvectors of the metric (5.3): particles that find no such place go on");
  item.add("share of runs with 5.16 that settle", nullptr, settled[1], "", {.min = 1.0});
  item.add("mean quality, 5.16 less 5.15", nullptr, quality[1] - quality[0],
           "5.3 says that 5.16 is used in practice, 5.5 that 5.15 is");
  return item;
}

}  // namespace parmesan::thesis
