#pragma once

#include <span>

#include "mesher/particles/blocks.h"
#include "mesher/particles/particle_options.h"
#include "mesher/particles/star.h"

namespace parmesan {

/// When a particle that has moved feels the metric at its new place, and its spokes are flipped:
/// at once, or in the next sweep that updates. Near equilibrium every second sweep is enough.
enum class Update { Now, Later };

/// Moves v by step, halved up to three times, if the star allows it: afterwards every triangle has
/// quality of at least 0.3, or the worst of them has become better. Returns whether it moved.
bool try_move(ParticleSystem& particles, const Star& star, VertexId v, const Vector& step, Update update);

/// Moves v along its segment towards the target, in the same way; on a curve it is always on it.
bool try_slide(ParticleSystem& particles, const Star& star, VertexId v, double target, Update update);

/// What moves the free particles in a sweep.
enum class Motion { Force, IdealApex };

/// How a sweep moves free particles.
struct SweepOptions {
  Motion motion = Motion::Force;
  Update update = Update::Now;
  double momentum = 0.0;                    // share of the last move added to the next, beta of 3.13
  const ParticleOptions* forces = nullptr;  // other than those of force_step, not owned
  bool only_resolved = false;               // leave alone the particles whose star does not resolve the metric
};

/// Visits every particle once, block by block of the given cut (see Blocks): free ones follow the motion, those on
/// a segment go towards their target parameter there (see boundary.h). An update flips the spokes
/// that fail the in-circle test 5.13. targets: one per vertex slot, NaN where there is none.
///
/// Momentum (second-order motion, thesis 3.13) acts only where the metric is resolved.
void sweep(ParticleSystem& particles, const Blocks& blocks, int cut, std::span<const double> targets,
           const SweepOptions& options = {});

}  // namespace parmesan
