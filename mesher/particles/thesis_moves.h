#pragma once

#include "mesher/particles/particle_options.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// What the thesis does to a triangulation of particles: each keeps every triangle counter-clockwise by exact
/// orientation and legalizes by the in-circle test 5.13 around the place, or is not done at all.

/// Moves v, which must not be fixed, by step; halved up to four times where the way is barred by a constraint, or,
/// in place, by the star. A bound particle slides along its segment, always in place. Returns the displacement.
Vector relocate(ParticleSystem& particles, VertexId v, const Vector& step, Relocation how);

/// Creates a particle on e or, at a circumcentre, of the larger triangle beside it where all its corners see that.
/// Returns its vertex; no_vertex where no valid place was found.
VertexId create_at(ParticleSystem& particles, EdgeId e, CreationPlace place);

/// Takes v, which must not be fixed, away; a bound particle always by collapse along its segment. Returns whether it
/// went.
bool annihilate(ParticleSystem& particles, VertexId v, Annihilation how);

}  // namespace parmesan
