#include "tools/cli/escape.h"

#include "mesher/io/utf8.h"

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

}  // namespace

std::string escape_control(std::string_view text, bool keep_newlines) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t length = utf8_length(text.substr(i));  // a terminal may obey lone bytes from 0x80 to 0x9f
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
