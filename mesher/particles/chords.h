#pragma once

#include "mesher/particles/particle_system.h"

namespace parmesan {

/// Mends chords: free edges longer than sqrt2 between two bound particles.
///
/// No motion mends them, since their ends stay on their segments; in most of the meshes with a few edges too
/// many they cut a corner of the domain. A chord gives way to the other diagonal of its two triangles, a free
/// end of which goes to the best place near by, or it is cut by a new particle that does. The change stays
/// only if that particle then has unit edges and triangles of quality 0.7 and more. To be done last: legalizing
/// would bring some back. Cost: O(n), a scan of the edges.
void mend_chords(ParticleSystem& particles);

}  // namespace parmesan
