#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "mesher/index.h"
#include "mesher/particles/particle_options.h"
#include "mesher/triangulation/quad_edge.h"

namespace parmesan {

/// The particles that are alive (thesis 3.5), and the random pick among them.
///
/// Uniform picks cost O(1); those weighted by speed O(log n), by a binary tree of sums.
class AliveParticles {
 public:
  explicit AliveParticles(Picking picking) : picking_(picking) {}

  bool empty() const { return list_.empty(); }
  std::int64_t size() const { return static_cast<std::int64_t>(list_.size()); }
  const std::vector<VertexId>& all() const { return list_; }
  bool contains(VertexId v) const { return static_cast<std::size_t>(v) < place_.size() && place_[at(v)] >= 0; }

  /// Wakes v, or only changes its weight. weight: positive; of no account for uniform picks.
  void wake(VertexId v, double weight);
  void put_to_sleep(VertexId v);

  /// One of those alive; there must be one.
  VertexId pick(std::mt19937_64& engine) const;

 private:
  void set_weight(VertexId v, double weight);

  Picking picking_;
  std::vector<VertexId> list_;
  std::vector<std::int32_t> place_;  // of each vertex in the list, -1 where it is not alive
  std::vector<double> sums_;         // heap of weights: node i has the sum of its children 2i and 2i + 1
};

}  // namespace parmesan
