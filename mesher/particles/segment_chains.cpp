#include "mesher/particles/segment_chains.h"

#include <algorithm>

#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/triangulation/star.h"

namespace parmesan {

std::vector<ChainEdge> chains(const ParticleSystem& particles) {
  const Triangulation& mesh = particles.mesh();
  std::vector<ChainEdge> all;
  for (std::int32_t q = 0; q < mesh.size(); ++q) {
    const EdgeId e{4 * q};
    if (!mesh.is_alive(q) || !mesh.is_constrained(e)) continue;
    const int s = mesh.segment(e);
    const Segment& segment = particles.domain().segments[at(s)];
    const double from = parameter_on(particles.domain(), segment, mesh.point(mesh.org(e)));
    const double to = parameter_on(particles.domain(), segment, mesh.point(mesh.dest(e)));
    all.push_back(from < to ? ChainEdge{s, from, to, e} : ChainEdge{s, to, from, sym(e)});
  }
  std::sort(all.begin(), all.end(), [](const ChainEdge& a, const ChainEdge& b) {
    return a.segment != b.segment ? a.segment < b.segment : a.from < b.from;
  });
  return all;
}

VertexId split_at(ParticleSystem& particles, EdgeId e, const Point& p, std::vector<EdgeId>& changed) {
  constexpr int most = 1000;
  Triangulation& mesh = particles.mesh();
  for (int removed = 0; removed <= most; ++removed) {
    const VertexId obstacle = obstacle_to_split(mesh, e, p);
    if (obstacle == no_vertex) return particles.create_on_edge(e, p);
    if (!particles.is_free(obstacle)) break;
    const std::vector<EdgeId> hole = remove_star(mesh, obstacle);
    changed.insert(changed.end(), hole.begin(), hole.end());
  }
  return no_vertex;
}

}  // namespace parmesan
