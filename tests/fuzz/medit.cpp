#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "tests/fuzz/check.h"

/// Any bytes are a Medit mesh, a metric, or a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    CHECK(parmesan::fuzz::has_right_indices(parmesan::parse_medit(text, "fuzz.mesh")));
  } catch (const parmesan::FileError&) {
  }
  try {
    parmesan::parse_medit_metric(text, "fuzz.sol");
  } catch (const parmesan::FileError&) {
  }
  return 0;
}
