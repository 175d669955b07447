#include "mesher/geometry/message_text.h"

#include <array>
#include <charconv>

namespace parmesan {

std::string text(int value) { return std::to_string(value); }

std::string text(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string text(const Point& p) { return "(" + text(p.x) + ", " + text(p.y) + ")"; }

}  // namespace parmesan
