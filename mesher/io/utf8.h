#pragma once

#include <cstddef>
#include <string_view>

namespace parmesan {

/// The number of bytes of the UTF-8 character at the start of a text that is not empty, 0 where there is none.
///
/// The second byte's bounds exclude overlong forms, surrogates and what lies beyond U+10FFFF
/// (Unicode 15, table 3-7).
std::size_t utf8_length(std::string_view text);

/// Whether a text is made of UTF-8 characters.
bool is_utf8(std::string_view text);

}  // namespace parmesan
