#pragma once

#include <string>

#include "adapt/summary.h"

namespace parmesan {

/// convergence.csv: a header and one line per iteration, absent values empty.
std::string convergence_csv(const Summary& summary);

}  // namespace parmesan
