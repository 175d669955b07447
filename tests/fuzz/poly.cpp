#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/triangle_files.h"

/// Any bytes are a geometry in Triangle's format, or a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const parmesan::Domain domain = parmesan::parse_poly(text, "fuzz.poly");
    for (const parmesan::Segment& segment : domain.segments) {
      for (const int point : {segment.a, segment.b}) {
        if (point < 0 || point >= static_cast<int>(domain.points.size())) __builtin_trap();
      }
    }
  } catch (const parmesan::FileError&) {
  }
  return 0;
}
