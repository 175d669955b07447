#include "tools/thesis/experiment.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>
#include <utility>

#include "mesher/index.h"
#include "mesher/io/svg.h"

#ifdef _OPENMP
#include <omp.h>
#endif

namespace parmesan::thesis {

Item::Item(std::string name, std::string title)
    : json_({{"name", name},
             {"title", title},
             {"values", Json::array()},
             {"tables", Json::array()},
             {"charts", Json::array()},
             {"pictures", Json::array()},
             {"notes", Json::array()}}) {}

void Item::add(const std::string& what, const Json& of_thesis, double ours, const std::string& why, Law law) {
  Json value{{"what", what}, {"thesis", of_thesis}, {"ours", ours}, {"why", why}};
  if (law.min) value["min"] = *law.min;
  if (law.max) value["max"] = *law.max;
  const bool holds = (!law.min || ours >= *law.min) && (!law.max || ours <= *law.max);
  if (law.min || law.max) value["holds"] = holds;
  json_["values"].push_back(value);
}

void Item::add_table(const std::string& title, std::vector<std::string> columns,
                     const std::vector<std::vector<Json>>& rows) {
  json_["tables"].push_back({{"title", title}, {"columns", columns}, {"rows", rows}});
}

void Item::add_picture(const std::string& file, const std::string& caption) {
  json_["pictures"].push_back({{"file", file}, {"caption", caption}});
}

void Item::add_chart(const std::string& title, std::vector<std::string> columns,
                     const std::vector<std::vector<double>>& rows, bool logarithmic) {
  json_["charts"].push_back({{"title", title}, {"columns", columns}, {"rows", rows}, {"logarithmic", logarithmic}});
}

void Item::add_note(const std::string& text) { json_["notes"].push_back(text); }

Run run(const Domain& domain, const MetricField& field, const GenerateOptions& options, std::optional<Mesh> previous) {
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t start = std::clock();
  GenerateResult made = generate(domain, field, options, std::move(previous));
  Run result;
  result.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  result.elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.quality = measure_quality(made.mesh, made.metrics);
  result.mesh = std::move(made.mesh);
  result.report = std::move(made.report.thesis);
  return result;
}

void use_threads([[maybe_unused]] int count) {
#ifdef _OPENMP
  omp_set_num_threads(count > 0 ? count : omp_get_num_procs());
#endif
}

GenerateOptions as_written(const ParticleOptions& thesis, std::uint64_t seed) {
  GenerateOptions options;
  options.schedule = Schedule::Thesis;
  options.particles = thesis;
  options.seed = seed;
  return options;
}

double size_for(double area, double vertices) { return std::sqrt(2.0 * area / (std::numbers::sqrt3 * vertices)); }

Domain polygon(const std::vector<Point>& corners) {
  Domain domain;
  domain.points = corners;
  const int n = static_cast<int>(corners.size());
  for (int i = 0; i < n; ++i) domain.segments.push_back({i, (i + 1) % n, i + 1});
  return domain;
}

Domain rectangle(double width, double height) { return polygon({{0, 0}, {width, 0}, {width, height}, {0, height}}); }

void draw(const Setting& setting, const std::string& file, const Mesh& mesh) {
  PictureOptions options;
  options.width_px = 480;
  options.show_axes = false;
  write_svg(setting.folder + "/" + file, mesh, options);
}

std::vector<std::vector<double>> histogram(const std::vector<double>& values, double low, double high, int bins) {
  std::vector<std::vector<double>> rows;
  rows.reserve(static_cast<std::size_t>(bins));
  const double width = (high - low) / bins;
  for (int i = 0; i < bins; ++i) rows.push_back({low + (i + 0.5) * width, 0.0});
  for (const double value : values) {
    const int bin = std::clamp(static_cast<int>((value - low) / width), 0, bins - 1);
    rows[at(bin)][1] += 1.0 / static_cast<double>(values.size());
  }
  return rows;
}

std::vector<double> angles_of(const Mesh& mesh) {
  std::vector<double> angles;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = mesh.points[at(t[k])];
      const Vector a = mesh.points[at(t[(k + 1) % 3])] - p;
      const Vector b = mesh.points[at(t[(k + 2) % 3])] - p;
      angles.push_back(std::atan2(cross(a, b), dot(a, b)) * 180.0 / std::numbers::pi);
    }
  }
  return angles;
}

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double lx = std::log(x[i]), ly = std::log(y[i]);
    sx += lx;
    sy += ly;
    sxx += lx * lx;
    sxy += lx * ly;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace parmesan::thesis
