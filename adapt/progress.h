#pragma once

#include <functional>
#include <span>
#include <string>

#include "adapt/sizing.h"

namespace parmesan {

/// What is told of a run or a comparison while it goes on.
struct Progress {
  std::string line;    // without newline
  double share = 0.0;  // of the way, in [0, 1]
};

/// Gets what is told, line by line.
using ProgressListener = std::function<void(const Progress&)>;

/// How far a loop has come: the logarithm of its error, or of its size where no error is aimed at, from the first pass
/// to the goal; or its passes among those that it may take, whichever is more. In [0, 1].
double share_of_way(std::span<const SizeStep> history, const SizeGoal& goal);

}  // namespace parmesan
