#include "mesher/particles/thesis_options.h"

#include <string>

#include "mesher/errors.h"

namespace parmesan {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw InputError("thesis schedule: " + what);
}

}  // namespace

void validate(const ThesisOptions& options) {
  require(options.decay > 0.0 && options.decay <= 100.0, "decay must be positive, and 100 at most");
  require(options.radius >= 1.0 && options.radius <= 10.0, "radius must be from 1 to 10 unit edges");
  require(options.step >= 0.0 && options.step <= 10.0, "step must be from 0 to 10");
  require(options.momentum >= 0.0 && options.momentum < 1.0, "momentum must be from 0 to below 1");
  require(options.alive_speed > 0.0 && options.alive_speed < 1.0, "alive_speed must be between 0 and 1");
  require(options.max_picks >= 1.0 && options.max_picks <= 1e9, "max_picks must be from 1 to 1e9");
}

}  // namespace parmesan
