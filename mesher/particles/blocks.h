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

/// The particles in the order of the curve they are numbered along, cut into blocks that threads work on
/// at the same time: 32 of them, fewer where they would be short.
///
/// What keeps threads apart: a particle is moved, and an edge flipped, only if every vertex it involves
/// is in the block's territory. A triangle with a vertex in a territory changes by that block's thread
/// alone, and a particle with a neighbour in another territory does not move. The particles left over
/// come afterwards: first in the blocks of the other cut, shifted by half a block, then one by one. So the result is
/// the same for any number of threads. Valid until particles are created or annihilated.
class Blocks {
 public:
  /// Cost: O(n).
  explicit Blocks(const ParticleSystem& particles);

  /// The blocks, which refer to this; cuts of even and of odd number are half a block apart.
  std::vector<Block> cut(int number) const&;
  std::vector<Block> cut(int number) const&& = delete;

  /// The same with only the given particles, which are in the order of blocks.
  std::vector<Block> cut(int number, const ParticleSystem& particles, std::span<const VertexId> some) const;

 private:
  std::size_t half_of(const ParticleSystem& particles, VertexId v) const;

  std::int32_t half_length_ = 4096;
  std::vector<VertexId> order_;
  std::vector<std::size_t> starts_;  // in order_, of each half block; one more at the end
};

}  // namespace parmesan
