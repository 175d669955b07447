#include "adapt/math_library.h"

#include <unistd.h>

#include <array>

namespace parmesan {

// Of another system's C library POSIX has no name to ask for.
std::string math_library() {
#ifdef _CS_GNU_LIBC_VERSION
  std::array<char, 64> name{};
  if (confstr(_CS_GNU_LIBC_VERSION, name.data(), name.size()) > 0) return name.data();
#endif
  return "unknown";
}

}  // namespace parmesan
