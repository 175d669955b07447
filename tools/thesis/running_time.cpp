#include <cmath>

#include "tools/thesis/gaussian.h"

namespace parmesan::thesis {

Item running_time(const Setting& setting) {
  Item item("running_time", "Fig. 5.6: running time and steps against the number of particles, for the Gaussian");
  const Domain domain = rectangle(3, 3);
  const std::vector<double> sizes =
      setting.quick ? std::vector<double>{500, 1500, 4500} : std::vector<double>{1000, 4000, 16000, 64000, 200000};
  const std::vector<double> further = setting.quick ? std::vector<double>{} : std::vector<double>{1e6, 4e6};
  constexpr double particles_per_factor = 2.0;  // of the metric, about
  std::vector<std::vector<Json>> rows;
  std::vector<std::vector<double>> times, steps;
  std::vector<double> n, seconds, picks, fast_n, fast_seconds;
  Run written, fast;
  const auto run_fast = [&](double size) {
    fast = run(domain, *metric_of_thesis(size / particles_per_factor), {});
    fast_n.push_back(fast.vertices());
    fast_seconds.push_back(fast.seconds);
  };
  for (const double size : sizes) {
    written = run(domain, *metric_of_thesis(size / particles_per_factor), as_written());
    run_fast(size);
    n.push_back(written.vertices());
    seconds.push_back(written.seconds);
    picks.push_back(static_cast<double>(written.report->picks));
    times.push_back({written.vertices(), written.seconds});
    steps.push_back({written.vertices(), picks.back()});
    rows.push_back({written.vertices(), written.seconds, picks.back(), written.picks_per_particle(),
                    written.quality.quality_mean, 100.0 * written.quality.unit_edges,
                    written.report->settled ? "yes" : "no", fast.vertices(), fast.seconds, fast.quality.quality_mean,
                    100.0 * fast.quality.unit_edges});
  }
  const double ratio = written.seconds / written.vertices() / (fast.seconds / fast.vertices());
  GenerateOptions least;
  least.preset = Preset::Fast;
  const auto best_of_three = [&](double Run::*time) {
    Run best;
    for (int i = 0; i < 3; ++i) {
      Run again = run(domain, *metric_of_thesis(sizes.back() / particles_per_factor), least);
      if (i == 0 || again.*time < best.*time) best = std::move(again);
    }
    return best;
  };
  const Run quickest = best_of_three(&Run::seconds);
  const double ratio_of_least = written.seconds / written.vertices() / (quickest.seconds / quickest.vertices());
  use_threads(0);
  const Run threaded = best_of_three(&Run::elapsed);
  use_threads(1);
  const double ratio_elapsed = written.elapsed / written.vertices() / (threaded.elapsed / threaded.vertices());
  const double better = quickest.quality.quality_mean - written.quality.quality_mean;
  const double better_unit = 100.0 * (quickest.quality.unit_edges - written.quality.unit_edges);
  for (const double size : further) {
    run_fast(size);
    rows.push_back({nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, fast.vertices(), fast.seconds,
                    fast.quality.quality_mean, 100.0 * fast.quality.unit_edges});
  }
  item.add_table("As written, and the fast schedule",
                 {"particles", "CPU s", "steps", "steps per particle", "mean quality", "unit edges, %", "settled",
                  "fast: particles", "CPU s (fast)", "mean quality (fast)", "unit edges, % (fast)"},
                 rows);
  item.add_chart("CPU seconds, as written", {"particles", "CPU s"}, times, true);
  item.add_chart("Steps, as written", {"particles", "steps"}, steps, true);
  item.add("exponent of time, as written", "slightly over 1", fitted_exponent(n, seconds),
           "caches have grown, and so have the meshes");
  item.add("exponent of steps, as written", "under 1", fitted_exponent(n, picks),
           "24 - 25 picks per particle at every size here", {.max = 1.1});
  item.add("exponent of time, fast schedule", nullptr, fitted_exponent(fast_n, fast_seconds));
  const std::string at = " at " + std::to_string(static_cast<int>(n.back())) + " particles";
  const std::string why =
      "the schedule as written gains from exact predicates with a filter, slots that are used again and "
      "large caches: 6 us per pick here";
  item.add("CPU time per particle, as written over fast (default preset, one thread)" + at, nullptr, ratio, why);
  item.add("CPU time per particle, as written over fast (preset fast, one thread)" + at, nullptr, ratio_of_least, why,
           setting.quick ? Law{} : Law{.min = 50.0});
  item.add("elapsed time per particle, as written over fast (preset fast, all threads)" + at, nullptr, ratio_elapsed,
           "picks in random order cannot be made by several threads; the best of three runs, on a machine left alone");
  item.add("mean quality, fast (preset fast) less as written" + at, nullptr, better, "",
           {.min = setting.quick ? -0.01 : 0.0});
  item.add("unit edges, fast (preset fast) less as written, %" + at, nullptr, better_unit, "",
           {.min = setting.quick ? -0.5 : 0.0});
  return item;
}

Item picking_order(const Setting& setting) {
  Item item("picking_order", "3.1.3 and 3.5: the order in which particles are picked");
  std::vector<std::vector<Json>> rows;
  std::array<double, 3> cost{};
  const ConstantField field(Metric::isotropic(size_for(1.0, setting.quick ? 1000 : 60000)));
  for (std::size_t k = 0; k < picking_names.size(); ++k) {
    ParticleOptions thesis;
    thesis.picking = picking_names[k].second;
    const Run made = run(rectangle(1, 1), field, as_written(thesis));
    cost[k] = 1e6 * made.seconds / static_cast<double>(made.report->picks);
    rows.push_back({std::string(picking_names[k].first), made.vertices(), made.seconds, cost[k],
                    made.picks_per_particle(), made.quality.quality_mean, 100.0 * made.quality.unit_edges,
                    made.report->settled ? "yes" : "no"});
  }
  item.add_table(
      "Uniform mesh of the unit square",
      {"picks", "particles", "CPU s", "us per pick", "picks per particle", "mean quality", "unit edges, %", "settled"},
      rows);
  item.add("time per pick, random over Hilbert order", nullptr, cost[0] / cost[2],
           "cache misses, which 5.8 blames: neighbours are picked one after the other",
           setting.quick ? Law{} : Law{.min = 1.0});
  item.add("time per pick, by speed over uniform", "higher", cost[1] / cost[0],
           "O(log n) instead of O(1), 'no improvement over the simple scheme'");
  return item;
}

}  // namespace parmesan::thesis
