#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "mesher/io/medit_fields.h"
#include "tests/fuzz/check.h"

/// Any bytes are a binary Medit mesh, a solution (text or binary), or a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    CHECK(parmesan::fuzz::has_right_indices(parmesan::parse_meshb(bytes, "fuzz.meshb")));
  } catch (const parmesan::FileError&) {
  }
  for (const auto& parse : {&parmesan::parse_sol, &parmesan::parse_solb}) {
    try {
      for (const auto& field : parse(bytes, "fuzz.sol").points) {
        CHECK(field.values.size() % static_cast<std::size_t>(field.components) == 0);
      }
    } catch (const parmesan::FileError&) {
    }
  }
  return 0;
}
