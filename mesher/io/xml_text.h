#pragma once

#include <string>
#include <string_view>

namespace parmesan {

/// The text with & < > " ' escaped, fit for XML content and attributes. Control characters, which
/// XML does not allow, become blanks; bytes that are no UTF-8 become question marks.
std::string xml_escaped(std::string_view text);

}  // namespace parmesan
