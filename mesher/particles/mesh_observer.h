#pragma once

#include <cstdint>
#include <functional>

#include "mesher/particles/particle_system.h"

namespace parmesan {

/// Sees particles while they are brought to equilibrium. step: picks of the thesis's schedule, finished levels of the
/// fast one. What it is given is valid during the call only.
using MeshObserver = std::function<void(const ParticleSystem& particles, std::int64_t step)>;

}  // namespace parmesan
