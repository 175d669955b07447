#pragma once

#include "mesher/particles/particle_system.h"

namespace parmesan {

/// Creates a particle at the circumcentre of the larger triangle at the free edge e, in the mean of its vertex metrics
/// (an answer to thesis 6.1), where all three corners see that place and every triangle made there has at least this
/// mean ratio. Else changes nothing and returns no_vertex. Leaves legalization to the caller.
VertexId create_at_circumcentre(ParticleSystem& particles, EdgeId e, double min_quality = 0.0);

}  // namespace parmesan
