#pragma once

#include <cstddef>
#include <vector>

#include "mesher/particles/particle_system.h"

namespace parmesan {

/// A constrained edge.
struct ChainEdge {
  int segment;
  double from;  // parameters of its end points
  double to;
  EdgeId edge;  // directed along the segment
};

/// The edges of all segments, each segment's from its first point to its last. Cost: O(n), a scan of the edges.
std::vector<ChainEdge> chains(const ParticleSystem& particles);

/// Calls f(first, last) for the range of each segment's edges.
template <class F>
void for_each_chain(const std::vector<ChainEdge>& all, F f) {
  for (std::size_t i = 0; i < all.size();) {
    std::size_t j = i;
    while (j < all.size() && all[j].segment == all[i].segment) ++j;
    f(i, j);
    i = j;
  }
}

/// Splits e at a point of its segment. Free particles between a chord and its curve, as a layer has many, are removed:
/// they lie outside, and without a way the chord would stay for good. Adds the edges that changed. Returns the
/// particle, no_vertex where the triangulation does not let it be.
VertexId split_at(ParticleSystem& particles, EdgeId e, const Point& p, std::vector<EdgeId>& changed);

}  // namespace parmesan
