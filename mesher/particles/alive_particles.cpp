#include "mesher/particles/alive_particles.h"

#include <algorithm>
#include <bit>

#include "mesher/index.h"

namespace parmesan {

void AliveParticles::wake(VertexId v, double weight) {
  const auto i = static_cast<std::size_t>(v);
  if (i >= place_.size()) place_.resize(i + 1, -1);
  if (place_[i] < 0) {
    place_[i] = static_cast<std::int32_t>(list_.size());
    list_.push_back(v);
  }
  if (picking_ == Picking::BySpeed) set_weight(v, weight);
}

void AliveParticles::put_to_sleep(VertexId v) {
  if (!contains(v)) return;
  std::int32_t& place = place_[at(v)];
  const VertexId last = list_.back();
  list_[at(place)] = last;
  place_[at(last)] = place;
  place = -1;
  list_.pop_back();
  if (picking_ == Picking::BySpeed) set_weight(v, 0.0);
}

// Sums are made anew from the children, so that rounding does not add up.
void AliveParticles::set_weight(VertexId v, double weight) {
  const auto i = static_cast<std::size_t>(v);
  std::size_t leaves = sums_.size() / 2;
  if (i >= leaves) {
    const std::vector<double> old(sums_.begin() + static_cast<std::ptrdiff_t>(leaves), sums_.end());
    leaves = std::bit_ceil(i + 1);
    sums_.assign(2 * leaves, 0.0);
    std::copy(old.begin(), old.end(), sums_.begin() + static_cast<std::ptrdiff_t>(leaves));
    for (std::size_t k = leaves - 1; k > 0; --k) sums_[k] = sums_[2 * k] + sums_[2 * k + 1];
  }
  sums_[leaves + i] = weight;
  for (std::size_t k = (leaves + i) / 2; k > 0; k /= 2) sums_[k] = sums_[2 * k] + sums_[2 * k + 1];
}

VertexId AliveParticles::pick(std::mt19937_64& engine) const {
  if (picking_ == Picking::Uniform) return list_[engine() % list_.size()];
  double rest = static_cast<double>(engine() >> 11U) * 0x1.0p-53 * sums_[1];
  std::size_t k = 1;
  while (k < sums_.size() / 2) {
    k *= 2;
    const bool goes_right = rest >= sums_[k] && sums_[k + 1] > 0.0;
    if (goes_right) rest -= sums_[k++];
  }
  return static_cast<VertexId>(k - sums_.size() / 2);
}

}  // namespace parmesan
