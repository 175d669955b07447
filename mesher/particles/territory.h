#pragma once

#include <cstdint>
#include <limits>

#include "mesher/particles/particle_system.h"

namespace parmesan {

/// The particles that one thread may touch: those with a place in [first, last); by default all.
class Territory {
 public:
  Territory() = default;
  Territory(std::int32_t first, std::int32_t last) : first_(first), last_(last) {}
  bool contains(const ParticleSystem& particles, VertexId v) const {
    return first_ <= particles.place(v) && particles.place(v) < last_;
  }

 private:
  std::int32_t first_ = std::numeric_limits<std::int32_t>::min();
  std::int32_t last_ = std::numeric_limits<std::int32_t>::max();
};

}  // namespace parmesan
