#include "mesher/io/xml_text.h"

#include <cstddef>

#include "mesher/io/utf8.h"

namespace parmesan {
namespace {

std::string escaped_ascii(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {c < ' ' || c == '\x7f' ? ' ' : c};
  }
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) result += '?';
    if (length == 1) result += escaped_ascii(text.front());
    if (length > 1) result += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

}  // namespace parmesan
