#include "mesher/particles/thesis_rules.h"

#include <numbers>

#include "mesher/index.h"
#include "mesher/metric/metric_length.h"
#include "mesher/particles/edge_measures.h"
#include "mesher/particles/neighbourhood.h"

namespace parmesan {

double gain_of_creation(double area, bool virtual_triangles) {
  const double extra = virtual_triangles ? 2.0 : 0.0;
  const double measure = area + extra * unit_triangle_area;
  return density_error(measure, (2.0 + extra) * unit_triangle_area) -
         density_error(measure, (4.0 + extra) * unit_triangle_area);
}

bool is_superfluous_on_segment(double lengths) { return lengths < std::numbers::sqrt2; }

namespace {

double length_of(const ParticleSystem& particles, EdgeId e, EdgeDistance distance) {
  const Triangulation& mesh = particles.mesh();
  return edge_distance(distance, displacement(particles, e), particles.metric(mesh.org(e)),
                       particles.metric(mesh.dest(e)));
}

bool is_required(const ParticleSystem& particles, EdgeId e) {
  const std::int32_t segment = particles.mesh().segment(e);
  return segment >= 0 && particles.domain().segments[at(segment)].required;
}

}  // namespace

bool is_to_be_annihilated(const ParticleSystem& particles, VertexId v, EdgeDistance distance) {
  const Triangulation& mesh = particles.mesh();
  if (particles.binding(v) == fixed_particle) return false;
  double lengths = 0.0;
  double area = 0.0;
  int num_triangles = 0;
  for_each_spoke(mesh, v, [&](EdgeId e) {
    if (mesh.is_constrained(e)) lengths += length_of(particles, e, distance);
    if (!mesh.is_inside_left(e)) return;
    area += left_area(particles, e);
    ++num_triangles;
  });
  return particles.is_free(v) ? is_superfluous_inside(area, num_triangles) : is_superfluous_on_segment(lengths);
}

EdgeId edge_to_split(const ParticleSystem& particles, VertexId v, EdgeDistance distance, bool virtual_triangles) {
  const Triangulation& mesh = particles.mesh();
  EdgeId best = no_edge;
  double best_gain = 0.0;
  for_each_spoke(mesh, v, [&](EdgeId e) {
    if (is_required(particles, e)) return;
    const double gain =
        mesh.is_constrained(e)
            ? gain_of_split(length_of(particles, e, distance))
            : gain_of_creation(left_area(particles, e) + left_area(particles, sym(e)), virtual_triangles);
    if (gain <= best_gain) return;
    best_gain = gain;
    best = e;
  });
  return best;
}

}  // namespace parmesan
