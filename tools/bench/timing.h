#pragma once

#include <ctime>

namespace parmesan::bench {

/// What one triangulation cost and how large it is.
struct Timing {
  double seconds = 0.0;  // of the processor
  long num_vertices = 0;
};

/// Times build(), but not the destruction of the triangulation that it returns.
template <class Build, class CountVertices>
Timing time(Build build, CountVertices count_vertices) {
  const std::clock_t start = std::clock();
  const auto triangulation = build();
  const std::clock_t end = std::clock();
  return {static_cast<double>(end - start) / CLOCKS_PER_SEC, static_cast<long>(count_vertices(triangulation))};
}

}  // namespace parmesan::bench
