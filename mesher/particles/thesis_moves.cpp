#include "mesher/particles/thesis_moves.h"

#include <algorithm>
#include <cassert>

#include "mesher/geometry/predicates.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/metric/metric_length.h"
#include "mesher/particles/circumcentre.h"
#include "mesher/particles/collapse.h"
#include "mesher/particles/curve_chords.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/star.h"
#include "mesher/triangulation/delaunay.h"
#include "mesher/triangulation/sight.h"
#include "mesher/triangulation/star.h"

namespace parmesan {
namespace {

constexpr long max_flips = 1000;  // 5.13 in varying metrics may cycle

/// The in-circle test 5.13 as insert_site and its kin want it.
struct MetricInCircle {
  const ParticleSystem& particles;
  bool operator()(const Triangulation&, EdgeId e) const { return wants_flip(particles, e); }
};

void legalize_around(ParticleSystem& particles, VertexId v) {
  legalize(particles.mesh(), star_edges(particles.mesh(), v), MetricInCircle{particles}, max_flips);
}

bool is_star_valid(const Triangulation& t, VertexId v, const Point& p) {
  bool valid = true;
  for_each_spoke(t, v, [&](EdgeId e) {
    if (!valid || !t.is_inside_left(e)) return;
    valid = orient2d(t.point(t.dest(e)), t.point(t.left_apex(e)), p) > 0.0;
  });
  return valid;
}

// Where a particle that wants to go to p comes to lie: a bound one on its segment, computed from its parameter there
// so that it does not drift off.
Point bound_place(const ParticleSystem& particles, VertexId v, const Point& p) {
  if (particles.is_free(v)) return p;
  const Domain& domain = particles.domain();
  const Segment& s = domain.segments[at(particles.binding(v))];
  return point_on(domain, s, std::clamp(parameter_on(domain, s, p), 0.0, 1.0));
}

// The middle of an edge, on the curve that it is a part of.
Point middle_of(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  const Domain& domain = particles.domain();
  const Point p = midpoint(mesh.point(mesh.org(e)), mesh.point(mesh.dest(e)));
  if (!mesh.is_constrained(e)) return p;
  const Segment& s = domain.segments[at(mesh.segment(e))];
  return s.is_straight() ? p : point_on(domain, s, parameter_on(domain, s, p));
}

// Removal and insertion: the freed slot is the one used again, so that v keeps its number.
void reinsert(ParticleSystem& particles, VertexId v, const Point& p) {
  Triangulation& mesh = particles.mesh();
  const VertexId near = mesh.dest(mesh.edge_of(v));
  remove_site(mesh, v, MetricInCircle{particles}, max_flips);
  const Location where = locate(mesh, p, mesh.edge_of(near));
  [[maybe_unused]] const VertexId again =
      where.hit == Hit::Edge ? mesh.split_edge(where.edge, p) : mesh.split_face(where.edge, p);
  assert(again == v);
  particles.move(v, p);
  legalize_star(mesh, v, MetricInCircle{particles});
}

}  // namespace

Vector relocate(ParticleSystem& particles, VertexId v, const Vector& step, Relocation how) {
  constexpr int max_tries = 5;
  Triangulation& mesh = particles.mesh();
  const Point from = mesh.point(v);
  const bool reinserts = how == Relocation::Reinsert && particles.is_free(v);
  Vector d = step;
  for (int i = 0; i < max_tries; ++i, d = 0.5 * d) {
    const Point to = bound_place(particles, v, from + d);
    if (to == from) return {};
    if (!(reinserts ? sees(mesh, v, to) : is_star_valid(mesh, v, to))) continue;
    if (reinserts) {
      reinsert(particles, v, to);
    } else {
      particles.move(v, to);
      legalize_around(particles, v);
    }
    return to - from;
  }
  return {};
}

VertexId create_at(ParticleSystem& particles, EdgeId e, CreationPlace place) {
  Triangulation& mesh = particles.mesh();
  VertexId v = no_vertex;
  if (place == CreationPlace::Circumcentre && !mesh.is_constrained(e)) v = create_at_circumcentre(particles, e);
  if (v == no_vertex) {
    const Point p = middle_of(particles, e);
    if (obstacle_to_split(mesh, e, p) != no_vertex) return no_vertex;
    v = particles.create_on_edge(e, p);
  }
  legalize_star(mesh, v, MetricInCircle{particles});
  return v;
}

namespace {

// The nearest neighbour that v may merge into, along its segment if it has one; no_edge if there is none.
EdgeId edge_to_collapse(const ParticleSystem& particles, VertexId v) {
  const Triangulation& mesh = particles.mesh();
  Star star;
  star.gather(particles, v);
  EdgeId nearest = no_edge;
  double smallest = 0.0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Star::Spoke& s = star.spoke(i);
    if (!particles.is_free(v) && mesh.segment(s.edge) != particles.binding(v)) continue;
    if (!keeps_constraints_apart(mesh, s.edge)) continue;
    const double length = squared_length_in_mean(s.point - mesh.point(v), particles.metric(v), s.metric);
    if (nearest != no_edge && length >= smallest) continue;
    if (star.quality_after_collapse(i) <= 0.0) continue;
    nearest = s.edge;
    smallest = length;
  }
  return nearest;
}

}  // namespace

bool annihilate(ParticleSystem& particles, VertexId v, Annihilation how) {
  Triangulation& mesh = particles.mesh();
  if (how == Annihilation::Removal && particles.is_free(v)) {
    remove_site(mesh, v, MetricInCircle{particles}, max_flips);
    return true;
  }
  if (!may_leave_curve(particles, v)) return false;
  const EdgeId e = edge_to_collapse(particles, v);
  if (e == no_edge) return false;
  const VertexId heir = mesh.dest(e);
  mesh.collapse(e);
  legalize_around(particles, heir);
  return true;
}

}  // namespace parmesan
