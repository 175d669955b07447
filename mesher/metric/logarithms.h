#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/metric/metric.h"
#include "mesher/parallel.h"

namespace parmesan {

/// log M of each metric, on all threads.
inline std::vector<SymmetricTensor> logarithms(std::span<const Metric> metrics) {
  std::vector<SymmetricTensor> logs(metrics.size());
  const Ranges ranges(metrics.size());
  parallel_for(ranges.count(), [&](int range) {
    for (std::size_t i = ranges.first(range); i < ranges.last(range); ++i) logs[i] = metrics[i].log();
  });
  return logs;
}

}  // namespace parmesan
