#pragma once

#include <string>

namespace parmesan {

/// "parmesan 0.1.0" and, one per line, the compiler, the kind of build, libraries and features.
std::string version_text();

}  // namespace parmesan
