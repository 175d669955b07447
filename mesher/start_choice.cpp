#include "mesher/start_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "mesher/index.h"
#include "mesher/metric/metric_length.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

// ln l of the sides of every n-th triangle, so that no more than so many are looked at.
std::vector<double> sampled_log_lengths(const Mesh& mesh, const MetricField& field) {
  constexpr std::size_t max_triangles = 1000;
  const std::size_t stride = (mesh.triangles.size() + max_triangles - 1) / max_triangles;
  std::vector<double> logs;
  MetricHint hint = -1;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += stride) {
    std::array<Point, 3> p;
    std::array<Metric, 3> m;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = mesh.points[at(mesh.triangles[t][k])];
      m[k] = field.at(p[k], hint);
    }
    for (std::size_t k = 0; k < 3; ++k)
      logs.push_back(std::log(metric_edge_length(p[(k + 1) % 3] - p[k], m[k], m[(k + 1) % 3])));
  }
  return logs;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::string describe(double misfit, int refinements) {
  const std::string cut = refinements > 0 ? ", cut into " + text(std::exp2(refinements), 3) + "," : "";
  return "the previous mesh's edges" + cut + " miss length 1 by a factor of " + text(std::exp(misfit), 3) +
         " in the mean";
}

}  // namespace

std::string_view to_string(Start start) {
  switch (start) {
    case Start::Scratch:
      return "scratch";
    case Start::PreviousMesh:
      return "previous_mesh";
    case Start::RefinedPreviousMesh:
      return "refined_previous_mesh";
  }
  return "";
}

StartChoice choose_start(const Mesh& previous, const MetricField& field) {
  constexpr double near_enough = 0.15;
  constexpr double as_dense = 0.05;
  if (previous.triangles.empty()) return {.reason = "the previous mesh has no triangles"};
  std::vector<double> logs = sampled_log_lengths(previous, field);
  const double mean_log = mean(logs);
  const int refinements = std::max(0, static_cast<int>(std::lround(mean_log / std::numbers::ln2)));
  for (double& log_length : logs) log_length = std::abs(log_length - refinements * std::numbers::ln2);
  const double misfit = mean(logs);
  const double excess = mean_log - refinements * std::numbers::ln2;
  StartChoice choice;
  choice.expected_vertices = previous.num_vertices() * std::exp(2.0 * mean_log);
  choice.reason = describe(misfit, refinements);
  if (!(misfit < near_enough && std::abs(excess) < as_dense)) return choice;
  choice.refinements = refinements;
  choice.start = refinements > 0 ? Start::RefinedPreviousMesh : Start::PreviousMesh;
  return choice;
}

}  // namespace parmesan
