#include "mesher/particles/blocks.h"

#include <algorithm>
#include <numeric>

namespace parmesan {

std::size_t Blocks::half_of(const ParticleSystem& particles, VertexId v) const {
  return static_cast<std::size_t>(particles.place(v) / half_length_);
}

// In each half by number: particles created since the curve was laid come after the others, which is better
// for the mesh than in between (mean quality .9959 for .9954).
Blocks::Blocks(const ParticleSystem& particles) {
  constexpr std::int32_t most_halves = 64;
  const Triangulation& mesh = particles.mesh();
  half_length_ = std::max(half_length_, mesh.num_slots() / most_halves);
  std::size_t halves = 0;
  for (VertexId v = 0; v < mesh.num_slots(); ++v) halves = std::max(halves, half_of(particles, v) + 1);
  starts_.assign(halves + 1, 0);
  for (VertexId v = 0; v < mesh.num_slots(); ++v)
    if (mesh.has_vertex(v)) ++starts_[half_of(particles, v) + 1];
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  order_.resize(starts_.back());
  std::vector<std::size_t> fill(starts_.begin(), starts_.end() - 1);
  for (VertexId v = 0; v < mesh.num_slots(); ++v)
    if (mesh.has_vertex(v)) order_[fill[half_of(particles, v)]++] = v;
}

std::vector<Block> Blocks::cut(int number) const& {
  std::vector<Block> blocks;
  const std::size_t halves = starts_.size() - 1;
  for (std::size_t first = 0, last = number % 2 == 0 ? 2 : 1; first < halves; first = last, last += 2) {
    last = std::min(last, halves);
    const std::span<const VertexId> all(order_);
    blocks.push_back(
        {all.subspan(starts_[first], starts_[last] - starts_[first]),
         Territory(static_cast<std::int32_t>(first) * half_length_, static_cast<std::int32_t>(last) * half_length_)});
  }
  return blocks;
}

std::vector<Block> Blocks::cut(int number, const ParticleSystem& particles, std::span<const VertexId> some) const {
  std::vector<Block> blocks = cut(number);
  std::size_t first = 0;
  for (Block& block : blocks) {
    std::size_t last = first;
    while (last < some.size() && block.territory.contains(particles, some[last])) ++last;
    block.particles = some.subspan(first, last - first);
    first = last;
  }
  return blocks;
}

}  // namespace parmesan
