#include <algorithm>
#include <iterator>

#include "mesher/triangulation/conversion.h"
#include "tools/thesis/experiment.h"

namespace parmesan::thesis {
namespace {

// A polygon with a bay and a hole, in the manner of Fig. 1.3, whose coordinates are not given.
Domain plate() {
  Domain domain = polygon({{0, 0}, {1.6, 0}, {1.6, 0.5}, {1.05, 0.5}, {1.05, 0.75}, {1.6, 0.75}, {1.6, 1.2}, {0, 1.2}});
  const int first = static_cast<int>(domain.points.size());
  for (const Point& p : {Point{0.3, 0.45}, Point{0.5, 0.3}, Point{0.7, 0.5}, Point{0.5, 0.8}})
    domain.points.push_back(p);
  for (int i = 0; i < 4; ++i) domain.segments.push_back({first + i, first + (i + 1) % 4, 9});
  domain.holes.push_back({0.5, 0.5});
  return domain;
}

void add_histograms(Item& item, const Run& run) {
  item.add_chart("Angles", {"degrees", "share"}, histogram(angles_of(run.mesh), 20, 120, 25), false);
  item.add_chart("Normalized edge lengths", {"length", "share"}, histogram(run.quality.lengths, 0.5, 1.6, 22), false);
}

}  // namespace

Item evolution(const Setting& setting) {
  Item item("evolution", "Fig. 1.3: evolution of a mesh");
  const double size = setting.quick ? 0.1 : 0.0667;
  GenerateOptions options = as_written();
  std::vector<std::int64_t> due{0, 50, 150, 400, 1000};
  std::vector<std::vector<double>> population;
  double settled_at = 0.0;  // picks until 99 % of the particles were there
  options.observer = [&](const ParticleSystem& particles, std::int64_t picks) {
    const double n = particles.mesh().num_vertices();
    const double step = 1.0 + static_cast<double>(picks);
    if (population.empty() || step >= 1.05 * population.back()[0]) population.push_back({step, n});
    if (due.empty() || picks < due.front()) return;
    due.erase(due.begin());
    const std::vector<int> labels(particles.domain().segments.size(), 0);
    const std::string file = "fig_1_3_" + std::to_string(picks) + ".svg";
    draw(setting, file, to_mesh(particles.mesh(), labels).mesh);
    item.add_picture(file, "after " + std::to_string(picks) + " steps");
  };
  const Run made = run(plate(), ConstantField(Metric::isotropic(size)), options);
  for (const auto& row : population)
    if (row[1] < 0.99 * made.vertices()) settled_at = row[0];
  draw(setting, "fig_1_3_end.svg", made.mesh);
  item.add_picture("fig_1_3_end.svg", "at equilibrium, after " + std::to_string(made.report->picks) + " steps");
  const std::string domain = "the domain and the size of Fig. 1.3 are not given: ours has the same kind";
  item.add("steps until equilibrium", 8410, static_cast<double>(made.report->picks), domain);
  item.add("steps until 99 % of the particles are there", 1000, settled_at, domain);
  item.add("particles", nullptr, made.vertices());
  item.add("settled (1) or not (0)", 1, made.report->settled ? 1.0 : 0.0, "", {.min = 1.0});
  item.add_chart("Population", {"steps", "particles"}, population, true);
  return item;
}

Item uniform_square(const Setting& setting) {
  Item item("uniform", "Fig. 3.10: unit square, size 0.02");
  const Run made = run(rectangle(1, 1), ConstantField(Metric::isotropic(setting.quick ? 0.04 : 0.02)), as_written());
  draw(setting, "fig_3_10.svg", made.mesh);
  item.add_picture("fig_3_10.svg", std::to_string(made.mesh.num_vertices()) + " particles");
  item.add("settled (1) or not (0)", 1, made.report->settled ? 1.0 : 0.0, "", {.min = 1.0});
  item.add("picks per particle", nullptr, made.picks_per_particle(), "the threshold of being alive is not given",
           {.max = 40.0});
  item.add("unit edges, %", nullptr, 100.0 * made.quality.unit_edges, "only histograms are printed",
           {.min = setting.quick ? 99.0 : 99.5});
  item.add("mean quality", nullptr, made.quality.quality_mean, "", {.min = 0.97});
  item.add("smallest angle, degrees", nullptr, made.quality.angle_min);
  item.add("CPU seconds", nullptr, made.seconds);
  add_histograms(item, made);
  return item;
}

Item potentials(const Setting& setting) {
  Item item("potentials", "3.3.6: potentials, neighbourhoods and orders");
  const ConstantField field(Metric::isotropic(setting.quick ? 0.1 : 0.04));
  std::vector<std::vector<Json>> rows;
  double best = 0.0;
  double of_approximation = 0.0;
  for (const auto& [name, potential] : potential_names) {
    for (const auto& [which, neighbourhood] : neighbourhood_names) {
      if (neighbourhood == Neighbourhood::Radius) continue;
      for (const double momentum : {0.0, 0.9}) {
        ParticleOptions thesis{.potential = potential, .neighbourhood = neighbourhood, .momentum = momentum};
        thesis.max_picks = setting.quick ? 60.0 : 300.0;
        const Run made = run(rectangle(1, 1), field, as_written(thesis));
        const MeshQuality& q = made.quality;
        rows.push_back({std::string(name), std::string(which), momentum > 0.0 ? 2 : 1, q.quality_mean, q.quality_min,
                        100.0 * q.unit_edges, made.vertices(), made.picks_per_particle(),
                        made.report->settled ? "yes" : "no"});
        if (neighbourhood != Neighbourhood::N1 || momentum > 0.0) continue;
        best = std::max(best, q.quality_mean);
        if (potential == PotentialKind::LennardJonesApproximation) of_approximation = q.quality_mean;
      }
    }
  }
  item.add_table("Unit square",
                 {"potential", "neighbourhood", "order", "mean quality", "lowest", "unit edges, %", "particles",
                  "picks per particle", "settled"},
                 rows);
  item.add("mean quality, 3.20 over N1, first order, of the best potential's", nullptr, of_approximation / best,
           "the thesis calls Lennard-Jones-like schemes best, without numbers", {.min = 0.97});
  item.add_note(
      "Second order is beta = 0.9 with a tenth of the step, so that a steady force moves particles as far; a "
      "run that has not settled was stopped at the cap on picks.");
  return item;
}

}  // namespace parmesan::thesis
