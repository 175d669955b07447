#pragma once

#include "adapt/progress.h"
#include "tools/cli/common_options.h"

namespace parmesan {

/// Prints each line to standard error, control characters escaped, and keeps a bar below them where that is a terminal;
/// the bar goes with the last copy. Empty when quiet.
ProgressListener progress_to_stderr(const CommonOptions& common);

}  // namespace parmesan
