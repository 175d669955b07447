#pragma once

#include <string>

namespace parmesan {

/// The library whose sin, exp and log are used, e.g. "glibc 2.36": two versions may differ in the last bit, and then
/// meshes of the same case and seed do.
std::string math_library();

}  // namespace parmesan
