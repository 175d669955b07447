#pragma once

#include <string>
#include <string_view>

namespace parmesan {

/// The text with control characters, and bytes that are not UTF-8, as \n, \t or \xHH, so that names from files cannot
/// steer a terminal. Line feeds stay when keep_newlines is set. Of UTF-8 the C1 controls are escaped too.
std::string escape_control(std::string_view text, bool keep_newlines = false);

}  // namespace parmesan
