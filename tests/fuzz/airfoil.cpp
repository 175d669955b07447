#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/airfoil_file.h"
#include "tests/fuzz/check.h"

/// Any bytes are the outline of an airfoil, or a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const parmesan::Domain domain = parmesan::parse_airfoil(text, "fuzz.dat");
    CHECK(domain.segments.size() == domain.points.size());
  } catch (const parmesan::FileError&) {
  }
  return 0;
}
