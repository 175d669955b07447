#pragma once

#include <cstdint>
#include <limits>

#include "mesher/particles/particle_options.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// When particles come and go: the area rules of thesis 3.4.2, met by a margin, and limits on lengths; and how.
struct PopulationRules {
  double long_edge = 1.2;                      // shorter ones are not split
  double short_edge = 0.6;                     // half of it: creation never makes what annihilation takes away
  double area_slack = 0.05;                    // margin of both area rules, for the same reason
  bool only_resolved = false;                  // leave alone what lies where the metric is not (Star::is_resolved)
  int most = std::numeric_limits<int>::max();  // to create or annihilate: longest edges, smallest stars first
  bool virtual_triangles = true;
  CreationPlace creation = CreationPlace::EdgeMidpoint;
  Annihilation annihilation = Annihilation::Collapse;
};

/// What no relaxation mends: for particles that are otherwise in place.
inline constexpr PopulationRules outlier_rules{.long_edge = 1.6, .short_edge = 0.5, .area_slack = 0.3};

/// Creates particles in the middle of free edges, or at circumcentres where those are seen, that are too long and whose
/// two triangles satisfy the rule of 3.4.2, A1 + A2 > 3/sqrt2 - sqrt3/2 with virtual triangles, sqrt(3/2) without;
/// longest first. Legalizes around each. Returns how many were created. Errors: LimitError beyond max_vertices.
int create_particles(ParticleSystem& particles, const PopulationRules& rules, std::int64_t max_vertices);

/// Annihilates free particles that satisfy the rule of 3.4.2, A(star) < sqrt(3 n (n - 2)) / 4 for n
/// triangles, or have a neighbour that is too near, by collapse into the nearest neighbour that
/// leaves a valid star, or by removal. Legalizes around each. Returns how many were annihilated.
int annihilate_particles(ParticleSystem& particles, const PopulationRules& rules);

/// How many particles, relative to their number, the rules would create and annihilate. Counted are
/// places where the metric is resolved (Star::is_resolved) and outliers anywhere: what the rules
/// find elsewhere is as much an accident of where the metric was sampled. Estimated from every n-th of more than
/// 20 000 particles or edges.
double population_demand(const ParticleSystem& particles, const PopulationRules& rules);

}  // namespace parmesan
