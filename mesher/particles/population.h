#pragma once

#include "mesher/particles/particle_system.h"

namespace parmesan {

/// Creates particles in the middle of free edges that are longer than 1.2 and whose two triangles
/// satisfy the rule of 3.4.2 with virtual triangles, A1 + A2 > 3/sqrt2 - sqrt3/2, by 5 %; longest first.
/// Legalizes around each. Returns how many were created. Errors: LimitError beyond max_vertices.
int create_particles(ParticleSystem& particles, std::int64_t max_vertices);

/// Annihilates free particles that satisfy the rule of 3.4.2, A(star) < sqrt(3 n (n - 2)) / 4 for n
/// triangles, by 5 %, or have a neighbour nearer than 0.6, by collapse into the nearest neighbour that
/// leaves a valid star. Legalizes around each. Returns how many were annihilated.
int annihilate_particles(ParticleSystem& particles);

/// Collapses one end of e into the other if that leaves valid triangles; a fixed particle stays, a
/// bound one goes only along its own segment. Returns whether it did.
bool collapse_if_valid(ParticleSystem& particles, EdgeId e);

}  // namespace parmesan
