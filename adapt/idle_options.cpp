#include "adapt/idle_options.h"

namespace parmesan {

std::vector<IdleOption> idle_options(const GenerateOptions& options) {
  const ParticleOptions usual;
  const ParticleOptions& set = options.particles;
  std::vector<IdleOption> idle;
  const auto require = [&idle](bool is_read, bool is_usual, const char* pointer, const char* problem) {
    if (!is_read && !is_usual) idle.push_back({pointer, problem});
  };
  const bool is_thesis = options.schedule == Schedule::Thesis;
  const char* of_thesis = "is for the schedule \"thesis\" only";
  require(is_thesis, set.alive_speed == usual.alive_speed, "/particles/alive_speed", of_thesis);
  require(is_thesis, set.relocation == usual.relocation, "/particles/relocation", of_thesis);
  require(is_thesis, set.picking == usual.picking, "/particles/picking", of_thesis);
  require(is_thesis, set.max_picks == usual.max_picks, "/particles/max_picks", of_thesis);
  require(set.potential == PotentialKind::LennardJonesApproximation, set.decay == usual.decay, "/particles/decay",
          "is for the potential \"lennard-jones-approximation\" only");
  require(set.neighbourhood == Neighbourhood::Radius, set.radius == usual.radius, "/particles/radius",
          "is for the neighbourhood \"radius\" only");
  return idle;
}

}  // namespace parmesan
