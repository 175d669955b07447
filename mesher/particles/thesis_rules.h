#pragma once

#include "mesher/particles/particle_options.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// The density error eps of 3.26 and 3.27: how far the measure of a set is from its ideal, as a ratio over 1.
constexpr double density_error(double measure, double ideal) {
  return measure > ideal ? measure / ideal : ideal / measure;
}

/// By how much eps falls when a constrained edge of this length is halved (3.4.1): positive from sqrt2 on.
constexpr double gain_of_split(double length) { return density_error(length, 1.0) - density_error(length, 2.0); }

/// By how much eps falls when an edge between two triangles of this area in sum is split (3.4.2): positive from
/// sqrt(3/2) on, with the two virtual triangles from 3 / sqrt2 - sqrt3 / 2 on.
double gain_of_creation(double area, bool virtual_triangles);

/// Should the particle between two constrained edges of these lengths in sum go (3.4.1): under sqrt2?
bool is_superfluous_on_segment(double lengths);

/// Should the particle with so many triangles of this area in sum go (3.4.2): A < sqrt(3 n (n - 2)) / 4?
constexpr bool is_superfluous_inside(double area, double num_triangles) {
  return area * area < 3.0 * num_triangles * (num_triangles - 2.0) / 16.0;
}

/// Should v be annihilated? By the rule for its segment, or by that for its star; a fixed one never.
bool is_to_be_annihilated(const ParticleSystem& particles, VertexId v, EdgeDistance distance);

/// The edge at v whose split lowers the density error most (3.4.3); no_edge when none does.
EdgeId edge_to_split(const ParticleSystem& particles, VertexId v, EdgeDistance distance, bool virtual_triangles);

}  // namespace parmesan
