#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/msh.h"
#include "tests/fuzz/check.h"

/// Any bytes are a Gmsh mesh with fields, or an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const parmesan::MeshData read = parmesan::parse_msh(bytes, "fuzz.msh");
    CHECK(parmesan::fuzz::has_right_indices(read.mesh));
    parmesan::check_fields(read.fields, read.mesh);
  } catch (const parmesan::InputError&) {
  }
  return 0;
}
