#include <cmath>
#include <numbers>

#include "mesher/metric/background_mesh.h"
#include "mesher/metric/feature_size.h"
#include "mesher/metric/gradation.h"
#include "tools/thesis/gaussian.h"

namespace parmesan::thesis {

Item remeshing(const Setting& setting) {
  Item item("remeshing", "6.1: remeshing from the previous mesh against scratch");
  const Domain domain = rectangle(3, 3);
  const double factor = setting.quick ? 300.0 : 2500.0;
  const Run start = run(domain, *metric_of_thesis(factor), as_written());
  std::vector<std::vector<Json>> rows;
  double smallest_change = 0.0;
  double largest_change = 0.0;
  const std::vector<double> shifts =
      setting.quick ? std::vector<double>{0.01, 0.5} : std::vector<double>{0.003, 0.01, 0.03, 0.1, 0.3, 1.0};
  for (const double shift : shifts) {
    const auto field = metric_of_thesis(factor, {shift, shift});
    const Run again = run(domain, *field, as_written(), start.mesh);
    const Run scratch = run(domain, *field, as_written());
    const double saved = static_cast<double>(again.report->picks) / static_cast<double>(scratch.report->picks);
    if (shift == shifts.front()) smallest_change = saved;
    largest_change = saved;
    rows.push_back({shift, again.vertices(), again.picks_per_particle(), again.seconds, again.quality.quality_mean,
                    scratch.picks_per_particle(), scratch.seconds, scratch.quality.quality_mean, saved});
  }
  item.add_table(
      "The Gaussian moves by (s, s)",
      {"s", "particles", "picks per particle, from previous", "CPU s, from previous", "quality, from previous",
       "picks per particle, scratch", "CPU s, scratch", "quality, scratch", "picks, ratio"},
      rows);
  item.add("picks from the previous mesh over scratch, smallest change", "asked for in 6.1", smallest_change, "",
           {.max = 0.8});
  item.add("picks from the previous mesh over scratch, largest change", "asked for in 6.1", largest_change);
  return item;
}

Item population(const Setting& setting) {
  Item item("population", "6.1: other ways to create, annihilate and move particles");
  const Domain domain = rectangle(3, 3);
  std::vector<std::vector<Json>> rows;
  double all_settled = 1.0;
  const auto field = metric_of_thesis(setting.quick ? 200.0 : 1500.0);
  const auto add = [&](const ParticleOptions& thesis, const char* relocation, const char* creation,
                       const char* annihilation, const char* triangles) {
    const Run made = run(domain, *field, as_written(thesis));
    all_settled = std::min(all_settled, made.report->settled ? 1.0 : 0.0);
    rows.push_back({relocation, creation, annihilation, triangles, made.vertices(), made.quality.quality_mean,
                    made.quality.quality_min, 100.0 * made.quality.unit_edges, made.picks_per_particle(),
                    made.report->created, made.report->annihilated, made.seconds});
  };
  for (const auto& [relocation, how] : relocation_names)
    for (const auto& [creation, place] : creation_names)
      for (const auto& [annihilation, goes] : annihilation_names)
        for (const bool virtual_triangles : {true, false})
          add({.virtual_triangles = virtual_triangles, .creation = place, .annihilation = goes, .relocation = how},
              relocation.data(), creation.data(), annihilation.data(), virtual_triangles ? "yes" : "no");
  item.add_table("The Gaussian of 5.6.1",
                 {"motion", "creation", "annihilation", "virtual triangles", "particles", "mean quality", "lowest",
                  "unit edges, %", "picks per particle", "created", "annihilated", "CPU s"},
                 rows);
  item.add("all variants settle (1) or not (0)", nullptr, all_settled);
  // Rows 0 and 4: reinsert, removal, virtual triangles, with midpoints and with circumcentres.
  const auto ratio = [&](std::size_t column) { return rows[4][column].get<double>() / rows[0][column].get<double>(); };
  item.add("annihilated, circumcentres over midpoints", "might need less smoothing", ratio(10),
           "fewer particles are created that have to go again");
  item.add("picks per particle, circumcentres over midpoints", "might need less smoothing", ratio(8),
           "motion takes most picks, wherever particles come from");
  item.add("mean quality, circumcentres less midpoints", "might be better",
           rows[4][5].get<double>() - rows[0][5].get<double>(), "motion has the last word");
  item.add_note(
      "Where removal and collapse agree to the last digit, all particles annihilated were on segments, where both "
      "are the collapse along the segment.");
  return item;
}

namespace {

/// A size that jumps from 0.02 to 0.2 at x = 1/2, sampled on a grid.
struct SampledMetric {
  Mesh mesh;
  std::vector<Metric> metrics;
};

SampledMetric jump(int n, double small, double large) {
  SampledMetric sampled;
  const auto id = [n](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n;
      sampled.mesh.points.push_back({x, static_cast<double>(j) / n});
      sampled.metrics.push_back(Metric::isotropic(std::abs(x - 0.5) < 0.01 ? small : large));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      sampled.mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      sampled.mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return sampled;
}

/// A hole whose 60 corners are nearer to each other than the size asked for.
Domain square_with_fine_hole() {
  Domain domain = rectangle(1, 1);
  constexpr int n = 60;
  for (int i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * i / n;
    domain.points.push_back({0.5 + 0.2 * std::cos(a), 0.5 + 0.2 * std::sin(a)});
    domain.segments.push_back({4 + i, 4 + (i + 1) % n, 5});
  }
  domain.holes.push_back({0.5, 0.5});
  return domain;
}

}  // namespace

Item oscillation(const Setting& setting) {
  Item item("oscillation", "6: where creation and annihilation go on for ever, and the cure");
  ParticleOptions thesis;
  thesis.max_picks = setting.quick ? 80.0 : 300.0;
  const Domain square = rectangle(1, 1);
  const SampledMetric abrupt = jump(100, 0.004, 0.1);
  const std::vector<Metric> graded = limit_gradation(abrupt.mesh, abrupt.metrics, 1.5);
  const Run oscillating = run(square, BackgroundMesh(abrupt.mesh, abrupt.metrics), as_written(thesis));
  const Run cured = run(square, BackgroundMesh(abrupt.mesh, graded), as_written(thesis));
  const Run fast = run(square, BackgroundMesh(abrupt.mesh, abrupt.metrics), {});
  draw(setting, "oscillation.svg", oscillating.mesh);
  draw(setting, "oscillation_cured.svg", cured.mesh);
  item.add_picture("oscillation.svg", "a thin layer of size 0.004 in size 0.1: " + oscillating.report->diagnosis);
  item.add_picture("oscillation_cured.svg",
                   "the same with gradation 1.5: settled after " + std::to_string(cured.report->picks) + " picks");
  item.add("abrupt metric: settled (1) or not (0)", 0, oscillating.report->settled ? 1.0 : 0.0,
           "the thesis admits it (6, robustness)", {.max = 0.0});
  item.add("abrupt metric: created or annihilated in the last tenth of the picks", nullptr,
           static_cast<double>(oscillating.report->lately_created_or_annihilated), "", {.min = 1.0});
  item.add("gradation 1.5: settled (1) or not (0)", nullptr, cured.report->settled ? 1.0 : 0.0,
           "sizes then grow no faster than a mesh can follow", {.min = 1.0});
  item.add("fast schedule on the abrupt metric: unit edges, %", nullptr, 100.0 * fast.quality.unit_edges,
           "a fixed number of rounds: it cannot oscillate, and says where the metric is missed");
  const Domain holed = square_with_fine_hole();
  const ConstantField coarse(Metric::isotropic(0.1));
  const BackgroundMesh features = feature_size_field(holed).sizes;
  const CallableField both([&](const Point& p) { return intersect(Metric::isotropic(0.1), features.at(p)); });
  const Run close = run(holed, coarse, as_written(thesis));
  const Run resolved = run(holed, both, as_written(thesis));
  draw(setting, "oscillation_points.svg", close.mesh);
  draw(setting, "oscillation_points_cured.svg", resolved.mesh);
  item.add_picture("oscillation_points.svg", "points five times nearer than the size: " + close.report->diagnosis);
  item.add_picture("oscillation_points_cured.svg", "sizes limited by the geometry's: settled after " +
                                                       std::to_string(resolved.report->picks) + " picks");
  item.add("points nearer than the size: settled (1) or not (0)", 0, close.report->settled ? 1.0 : 0.0,
           "the thesis admits it (6, robustness)", {.max = 0.0});
  item.add("sizes limited by an a-priori size from the geometry: settled (1) or not (0)", "expected in 6.1",
           resolved.report->settled ? 1.0 : 0.0, "", {.min = 1.0});
  return item;
}

}  // namespace parmesan::thesis
