#include "tools/cli/escape.h"

#include <algorithm>

namespace parmesan {
namespace {

std::string escaped(unsigned char byte) {
  constexpr std::string_view digits = "0123456789abcdef";
  if (byte == '\n') return "\\n";
  if (byte == '\t') return "\\t";
  if (byte == '\r') return "\\r";
  return std::string("\\x") + digits[byte >> 4] + digits[byte & 15];
}

// U+0080 to U+009F, which terminals may obey, are 0xc2 followed by 0x80 to 0x9f.
bool starts_c1_control(std::string_view text) {
  return text.size() >= 2 && text[0] == '\xc2' && static_cast<unsigned char>(text[1]) < 0xa0;
}

// Bytes of the UTF-8 character at the start of the text; 0 where none starts. A terminal of another encoding may obey
// a lone byte from 0x80 to 0x9f.
std::size_t character_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (length > text.size()) return 0;
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
  return length > 1 && !std::ranges::all_of(text.substr(1, length - 1), continues) ? 0 : length;
}

}  // namespace

std::string escape_control(std::string_view text, bool keep_newlines) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t length = character_length(text.substr(i));
    if (starts_c1_control(text.substr(i))) {
      result += escaped(static_cast<unsigned char>(text[++i]));
    } else if (length == 0 || (byte < 0x20 && !(keep_newlines && byte == '\n')) || byte == 0x7f) {
      result += escaped(byte);
    } else {
      result += text.substr(i, length);
      i += length - 1;
    }
  }
  return result;
}

}  // namespace parmesan
