#include "mesher/particles/circumcentre.h"

#include "mesher/particles/edge_measures.h"
#include "mesher/triangulation/locate.h"
#include "mesher/triangulation/sight.h"

namespace parmesan {
namespace {

// In the metric m: 2 (b - a)^T M (x - a) = (b - a)^T M (b - a), and the same with c.
Point circumcentre(const Point& a, const Point& b, const Point& c, const Metric& m) {
  const Vector mb = m.tensor() * (b - a);
  const Vector mc = m.tensor() * (c - a);
  const double rb = 0.5 * dot(mb, b - a);
  const double rc = 0.5 * dot(mc, c - a);
  const double det = cross(mb, mc);
  return a + (1.0 / det) * Vector{rb * mc.y - rc * mb.y, rc * mb.x - rb * mc.x};
}

// Would p in the triangle left of e make triangles of this quality? The one on e itself aside where p lies on e.
bool splits_well(const ParticleSystem& particles, EdgeId e, const Point& p, bool is_on_e, double min_quality) {
  const Triangulation& mesh = particles.mesh();
  const Metric m = mean_metric_left(particles, e);
  EdgeId side = e;
  for (int i = 0; i < 3; ++i, side = mesh.lnext(side)) {
    if (i == 0 && is_on_e) continue;
    if (mean_ratio(mesh.point(mesh.org(side)), mesh.point(mesh.dest(side)), p, m) < min_quality) return false;
  }
  return true;
}

}  // namespace

VertexId create_at_circumcentre(ParticleSystem& particles, EdgeId e, double min_quality) {
  Triangulation& mesh = particles.mesh();
  const EdgeId side = left_area(particles, e) >= left_area(particles, sym(e)) ? e : sym(e);
  const VertexId a = mesh.org(side);
  const VertexId b = mesh.dest(side);
  const VertexId c = mesh.left_apex(side);
  const Point p = circumcentre(mesh.point(a), mesh.point(b), mesh.point(c), mean_metric_left(particles, side));
  for (const VertexId corner : {a, b, c})  // one that ends a segment sees both sides of it
    if (!sees(mesh, corner, p)) return no_vertex;
  const Location where = locate(mesh, p, side);
  if (where.hit == Hit::Face && splits_well(particles, where.edge, p, false, min_quality))
    return particles.create_in_face(where.edge, p);
  const bool is_on_free_edge = where.hit == Hit::Edge && !mesh.is_constrained(where.edge);
  if (is_on_free_edge && splits_well(particles, where.edge, p, true, min_quality) &&
      splits_well(particles, sym(where.edge), p, true, min_quality))
    return particles.create_on_edge(where.edge, p);
  return no_vertex;
}

}  // namespace parmesan
