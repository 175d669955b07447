#pragma once

#include "mesher/particles/star.h"

namespace parmesan {

/// The place near a particle, whose star is given, where the sum
///
///     sum over triangles (1 - q)^2 + 10 max(0, 0.65 - Q)^2 + 3 sum over edges max(0, |ln l| - ln 1.34)^2
///
/// is smallest: q is a triangle's mean ratio in the mean of its vertex metrics, Q in the densest of them, counted where
/// it is above 0.5; lengths are those of metric_edge_length. A search in eight directions of the metric, by steps of
/// 0.15 and less.
Point best_place_near(const ParticleSystem& particles, const Star& star, VertexId v);

/// Moves the free particles that have an edge longer than 1.34 or shorter than 1 / 1.34, or a triangle of q under 0.7
/// or Q under 0.65, to the best place near by, and legalizes around them; then once more those that still have. Those
/// that then have a triangle of q under 0.1 are merged into a neighbour where that doubles it. Relaxation leaves about
/// one edge in a hundred out of [1/sqrt2, sqrt2] where the metric varies much; this mends two of three. Cost: O(n).
void repair_places(ParticleSystem& particles);

}  // namespace parmesan
