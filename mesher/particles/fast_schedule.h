#pragma once

#include <cstdint>

#include "mesher/particles/particle_options.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// Effort of one meshing: how often population, connectivity and places are brought to agree.
struct FastScheduleOptions {
  int rounds = 3;            // of population, flips and relaxation
  int sweeps_per_round = 2;  // force sweeps after each change of the population
  int final_force_sweeps = 8;
  int final_apex_sweeps = 3;
  int repairs = 1;
  int further_rounds = 0;          // where a tenth of the particles or more does not resolve the metric
  bool may_be_settled = true;      // a start that wants few changes keeps its population
  double momentum = 0.35;          // beta of thesis 3.13, while the population settles
  ParticleOptions particles = {};  // forces, and how particles come and go
  std::int64_t max_vertices = 10'000'000;
};

/// Brings particles to equilibrium: every edge near metric length 1.
///
/// The thesis's particles, forces and population rules, rearranged for the machine: whole sweeps
/// in the order of memory instead of random picks, motion in place with flips in a pass of their
/// own instead of removal and reinsertion, segments by their exact 1-D rule. A start that is settled,
/// where the density is right within 4 % and the rules of population would change fewer than 6 particles in a thousand
/// (13 where more than a tenth lie where the metric is not resolved), keeps its population but for outliers. See
/// mesher/README.md for the evidence. Cost: O(n) per sweep.
void run_fast_schedule(ParticleSystem& particles, const FastScheduleOptions& options);

}  // namespace parmesan
