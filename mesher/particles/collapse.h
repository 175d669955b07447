#pragma once

#include "mesher/particles/particle_system.h"
#include "mesher/particles/star.h"

namespace parmesan {

/// May v merge into the neighbour at the end of its spoke e? Where all is worse than the limit of 0.1, a collapse that
/// makes nothing worse is the way out.
bool can_collapse(const ParticleSystem& particles, const Star& star, VertexId v, EdgeId e);

/// Would collapsing e keep the constrained edges apart? Two of them would become one if they are the other sides of a
/// triangle beside e, inside the domain or a hole. That happens on curves only. Cost: O(1).
bool keeps_constraints_apart(const Triangulation& mesh, EdgeId e);

/// Collapses one end of e into the other if that leaves valid triangles; a fixed particle stays, a
/// bound one goes only along its own segment. Returns whether it did.
bool collapse_if_valid(ParticleSystem& particles, EdgeId e);

}  // namespace parmesan
