#pragma once

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

inline void check_indices(const Domain& domain) {
  for (const Segment& segment : domain.segments)
    for (const int point : {segment.a, segment.b}) CHECK(point >= 0 && point < static_cast<int>(domain.points.size()));
}

inline void check_indices(const Mesh& mesh) {
  CHECK(mesh.labels.size() == mesh.edges.size());
  CHECK(mesh.regions.size() == mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    for (const int vertex : triangle) CHECK(vertex >= 0 && vertex < mesh.num_vertices());
}

}  // namespace parmesan::fuzz
