#pragma once

#include <string>

#include "mesher/histogram.h"

namespace parmesan {

/// One line per bin: bounds, share, and a bar. Lines end in a line feed.
std::string text(const Histogram& histogram);

}  // namespace parmesan
