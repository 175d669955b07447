#include "mesher/vertex_limit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/errors.h"

namespace parmesan {

// Directed edges are numbered 4q + r in 32 bits, and a mesh has three times as many edges as vertices.
constexpr std::int64_t most_vertices = (std::int64_t{1} << 29) / 3;

void require_within_limit(const Mesh& mesh, std::int64_t max_vertices) {
  if (mesh.num_vertices() <= max_vertices) return;
  throw LimitError("a mesh of this domain has " + std::to_string(mesh.num_vertices()) + " vertices; the limit is " +
                   std::to_string(max_vertices));
}

void require_few_vertices(double expected, std::int64_t max_vertices) {
  max_vertices = std::min(max_vertices, most_vertices);
  if (expected <= static_cast<double>(max_vertices)) return;
  const bool is_countable = expected < 1e18;
  throw LimitError("the metric asks for " +
                   (is_countable ? "about " + std::to_string(std::llround(expected)) : "more than 10^18") +
                   " vertices; the limit is " + std::to_string(max_vertices));
}

}  // namespace parmesan
