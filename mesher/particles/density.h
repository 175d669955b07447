#pragma once

#include <cstdint>

#include "mesher/particles/population.h"

namespace parmesan {

/// Share of the particles that are free and lie where the metric is not resolved (Star::is_resolved); estimated from
/// every n-th of more than 5000.
double unresolved_share(const ParticleSystem& particles);

/// Area of the mesh in the metric per particle over that of a unit mesh, sqrt3 / 2: above 1 there are too few
/// particles, though each edge alone may be within the rules. Boundaries, and places where the metric is not resolved,
/// aside; estimated from every n-th of more than 5000 particles, to 0.2 %.
double area_per_particle(const ParticleSystem& particles);

/// Splits the longest edges, or annihilates the particles with the smallest stars, that the rules let be, until the
/// area per particle is that of a unit mesh: the rules leave it free by 15 %. Does nothing within 3 %.
void match_density(ParticleSystem& particles, PopulationRules rules, std::int64_t max_vertices);

}  // namespace parmesan
