#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/particles/territory.h"

namespace parmesan {

/// Particles that are near one another, in the order of their places.
struct Block {
  std::span<const VertexId> particles;
  Territory territory;
};

/// The particles in the order of the curve they are numbered along, cut into blocks of a fixed length
/// that threads work on at the same time.
///
/// What keeps threads apart: a particle is moved, and an edge flipped, only if every vertex it involves
/// is in the block's territory. A triangle with a vertex in a territory changes by that block's thread
/// alone, and a particle with a neighbour in another territory does not move. The particles left over
/// come afterwards, one by one; the next cut is shifted by half a block. So the result is the same for
/// any number of threads. Valid until particles are created or annihilated.
class Blocks {
 public:
  /// Cost: O(n).
  explicit Blocks(const ParticleSystem& particles);

  /// The blocks, which refer to this; cuts of even and of odd number are half a block apart.
  std::vector<Block> cut(int number) const&;
  std::vector<Block> cut(int number) const&& = delete;

 private:
  std::vector<VertexId> order_;
  std::vector<std::size_t> starts_;  // in order_, of each half block; one more at the end
};

}  // namespace parmesan
