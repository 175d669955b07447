#include "mesher/particles/blocks.h"

#include <algorithm>
#include <numeric>

namespace parmesan {
namespace {

constexpr std::int32_t half_length = 4096;

std::size_t half_of(const ParticleSystem& particles, VertexId v) {
  return static_cast<std::size_t>(particles.place(v) / half_length);
}

}  // namespace

// In each half by number: particles created since the curve was laid come after the others, which is better
// for the mesh than in between (mean quality .9959 for .9954).
Blocks::Blocks(const ParticleSystem& particles) {
  const Triangulation& mesh = particles.mesh();
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
         Territory(static_cast<std::int32_t>(first) * half_length, static_cast<std::int32_t>(last) * half_length)});
  }
  return blocks;
}

}  // namespace parmesan
