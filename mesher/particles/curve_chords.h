#pragma once

#include "mesher/particles/particle_system.h"

namespace parmesan {

/// May a particle on a curve go: is the edge that takes the place of its two near enough to the curve?
/// True for other particles. Cost: that of two searches of nearest points.
bool may_leave_curve(const ParticleSystem& particles, VertexId v);

/// Splits edges that are farther from their curve than its chord error allows, where the triangulation lets them be,
/// for what motion could not bring to its place. Legalizes around each.
void split_distant_chords(ParticleSystem& particles);

}  // namespace parmesan
