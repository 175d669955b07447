#include "mesher/particles/particle_options.h"

#include <string>

#include "mesher/errors.h"

namespace parmesan {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw InputError("particles: " + what);
}

}  // namespace

void validate(const ParticleOptions& options) {
  require(options.decay > 0.0 && options.decay <= 100.0, "decay must be positive, and 100 at most");
  require(options.radius >= 1.0 && options.radius <= 10.0, "radius must be from 1 to 10 unit edges");
  require(!options.step || (*options.step > 0.0 && *options.step <= 10.0), "step must be positive, and 10 at most");
  require(!options.momentum || (*options.momentum >= 0.0 && *options.momentum < 1.0),
          "momentum must be from 0 to below 1");
  require(options.alive_speed > 0.0 && options.alive_speed < 1.0, "alive_speed must be between 0 and 1");
  require(options.max_picks >= 1.0 && options.max_picks <= 1e9, "max_picks must be from 1 to 1e9");
}

bool has_default_forces(const ParticleOptions& options) {
  const ParticleOptions usual;
  return options.potential == usual.potential && options.decay == usual.decay &&
         options.neighbourhood == usual.neighbourhood && options.force == usual.force &&
         options.distance == usual.distance && !options.step && !options.momentum;
}

}  // namespace parmesan
