#pragma once

#include <cstdint>
#include <string>

#include "mesher/particles/mesh_observer.h"
#include "mesher/particles/particle_options.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// How a run of the thesis's schedule went.
struct ThesisReport {
  bool settled = false;  // no particle is left alive
  std::int64_t picks = 0;
  std::int64_t created = 0;
  std::int64_t annihilated = 0;
  std::int64_t alive = 0;                          // when it ended
  std::int64_t lately_created_or_annihilated = 0;  // in the last tenth of the picks
  Point unrest;                                    // where, when not settled, population or motion goes on most
  std::string diagnosis;                           // one sentence when not settled
};

/// F. Bossen's algorithm as it was written (CMU-CS-96-134, 3.1.3, 3.4.3, 3.5, 5.5).
///
/// Until none is alive: picks a particle that is alive at random, moves it by 3.12 or 3.13, annihilates it or splits
/// an edge at it by 3.4.3, the triangulation being Delaunay in the metric (5.13) all the time. A particle that moved
/// faster than alive_speed wakes its neighbours, a slower one goes to sleep. Steps are cut to half a unit edge. Where
/// the rules of population conflict it never ends (thesis 6): after max_picks per particle it stops and says where.
///
/// Serial. Same particles, options and seed: same bits. Every state is a valid triangulation.
/// Errors: LimitError beyond max_vertices; InputError for options out of range. Cost: O(1) per pick, but for the
/// weighted ones; some tens of picks per particle.
ThesisReport run_thesis_schedule(ParticleSystem& particles, const ParticleOptions& options, std::uint64_t seed,
                                 std::int64_t max_vertices, const MeshObserver& observer = {});

}  // namespace parmesan
