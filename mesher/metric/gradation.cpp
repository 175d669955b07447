#include "mesher/metric/gradation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>

#include "mesher/errors.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

constexpr double relative_slack = 1e-6;
constexpr std::size_t most_visits = 200;  // of a vertex, on average

// Neighbours of every vertex in compressed rows; an interior neighbour is listed twice.
struct VertexNeighbors {
  std::vector<std::size_t> start;
  std::vector<int> vertex;
};

VertexNeighbors vertex_neighbors(const Mesh& mesh) {
  VertexNeighbors n;
  n.start.assign(mesh.points.size() + 1, 0);
  for (const auto& t : mesh.triangles)
    for (const int v : t) n.start[static_cast<std::size_t>(v) + 1] += 2;
  for (std::size_t v = 1; v < n.start.size(); ++v) n.start[v] += n.start[v - 1];
  n.vertex.resize(n.start.back());
  std::vector<std::size_t> fill(n.start.begin(), n.start.end() - 1);
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::size_t& next = fill[at(t[k])];
      n.vertex[next++] = t[(k + 1) % 3];
      n.vertex[next++] = t[(k + 2) % 3];
    }
  }
  return n;
}

// a >= b in the sense of quadratic forms, with the slack on a.
bool at_least(const Metric& a, const Metric& b) {
  const SymmetricTensor difference = (1.0 + relative_slack) * a.tensor() - b.tensor();
  return difference.xx >= 0.0 && difference.yy >= 0.0 && determinant(difference) >= 0.0;
}

}  // namespace

double growth_factor(const Metric& m, const Vector& d, double beta) {
  const double growth = 1.0 + m.length(d) * std::log(beta);
  return 1.0 / (growth * growth);
}

std::vector<Metric> limit_gradation(const Mesh& mesh, std::span<const Metric> metrics, double beta) {
  if (!(beta > 1.0)) throw InputError("the gradation must be greater than 1, not " + std::to_string(beta));
  if (metrics.size() != mesh.points.size()) throw InputError("gradation needs one metric per vertex");
  const VertexNeighbors neighbors = vertex_neighbors(mesh);
  std::vector<Metric> graded(metrics.begin(), metrics.end());
  std::vector<std::size_t> active(metrics.size());
  std::iota(active.begin(), active.end(), std::size_t{0});
  for (std::size_t visits = 0; !active.empty() && visits < most_visits * metrics.size();) {
    std::vector<std::size_t> next;
    for (const std::size_t p : active) {
      for (std::size_t k = neighbors.start[p]; k < neighbors.start[p + 1]; ++k) {
        const auto q = static_cast<std::size_t>(neighbors.vertex[k]);
        const Metric& from = graded[p];
        const Metric spanned = from.scaled(growth_factor(from, mesh.points[q] - mesh.points[p], beta));
        if (at_least(graded[q], spanned)) continue;
        graded[q] = intersect(graded[q], spanned);
        next.push_back(q);
      }
    }
    visits += active.size();
    std::ranges::sort(next);
    next.erase(std::unique(next.begin(), next.end()), next.end());
    active = std::move(next);
  }
  return graded;
}

}  // namespace parmesan
