#include "mesher/particles/curve_chords.h"

#include <algorithm>
#include <vector>

#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/segment_chains.h"

namespace parmesan {

bool may_leave_curve(const ParticleSystem& particles, VertexId v) {
  const Domain& domain = particles.domain();
  const Triangulation& mesh = particles.mesh();
  if (particles.binding(v) < 0) return true;
  const Segment& s = domain.segments[at(particles.binding(v))];
  if (s.is_straight()) return true;
  double from = 1.0;
  double to = 0.0;
  for_each_spoke(mesh, v, [&](EdgeId e) {
    if (!mesh.is_constrained(e)) return;
    const double t = parameter_on(domain, s, mesh.point(mesh.dest(e)));
    from = std::min(from, t);
    to = std::max(to, t);
  });
  return domain.curves[at(s.curve)].is_near_chord(from, to);
}

void split_distant_chords(ParticleSystem& particles) {
  constexpr int max_passes = 20;
  const Domain& domain = particles.domain();
  if (domain.curves.empty()) return;
  bool any = true;  // were split in the last pass
  for (int pass = 0; any && pass < max_passes; ++pass) {
    any = false;
    std::vector<EdgeId> stack;
    for (const ChainEdge& e : chains(particles)) {
      const Segment& s = domain.segments[at(e.segment)];
      if (s.is_straight()) continue;
      const Curve& curve = domain.curves[at(s.curve)];
      if (curve.is_near_chord(e.from, e.to)) continue;
      const Point p = curve.at(0.5 * (e.from + e.to));
      const VertexId v = split_at(particles, e.edge, p, stack);
      if (v == no_vertex) continue;
      add_link(particles.mesh(), v, stack);
      any = true;
    }
    legalize(particles, stack, flips_after_change * static_cast<long>(stack.size()));
  }
}

}  // namespace parmesan
