#pragma once

#include <string>
#include <string_view>

namespace parmesan {

/// The text with control characters as \n, \t or \xHH, so that names from files cannot steer a
/// terminal. Line feeds stay when keep_newlines is set. UTF-8 passes, but for its C1 controls.
std::string escape_control(std::string_view text, bool keep_newlines = false);

}  // namespace parmesan
