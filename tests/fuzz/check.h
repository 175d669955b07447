#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

/// Ends the fuzzer, which then keeps the input, where the condition does not hold.
#define CHECK(condition)                                                                  \
  do {                                                                                    \
    if (!(condition)) {                                                                   \
      std::fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                       \
    }                                                                                     \
  } while (false)

namespace parmesan::fuzz {

inline bool has_right_indices(const Domain& domain) {
  const auto is_point = [&domain](int p) { return p >= 0 && p < static_cast<int>(domain.points.size()); };
  return std::ranges::all_of(domain.segments, [&](const Segment& s) { return is_point(s.a) && is_point(s.b); });
}

inline bool has_right_indices(const Mesh& mesh) {
  const auto is_vertex = [&mesh](int v) { return v >= 0 && v < mesh.num_vertices(); };
  return mesh.labels.size() == mesh.edges.size() && mesh.regions.size() == mesh.triangles.size() &&
         std::ranges::all_of(mesh.triangles, [&](const auto& t) { return std::ranges::all_of(t, is_vertex); });
}

}  // namespace parmesan::fuzz
