#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/triangle_files.h"
#include "tests/fuzz/check.h"

/// Any bytes are a geometry in Triangle's format, or a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    CHECK(parmesan::fuzz::has_right_indices(parmesan::parse_poly(text, "fuzz.poly")));
  } catch (const parmesan::FileError&) {
  }
  return 0;
}
