#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "mesher/io/medit_fields.h"

/// Any bytes are a binary Medit mesh, a solution (text or binary), or a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const parmesan::Mesh mesh = parmesan::parse_meshb(bytes, "fuzz.meshb");
    if (mesh.labels.size() != mesh.edges.size() || mesh.regions.size() != mesh.triangles.size()) __builtin_trap();
    for (const auto& triangle : mesh.triangles) {
      for (const int vertex : triangle) {
        if (vertex < 0 || vertex >= mesh.num_vertices()) __builtin_trap();
      }
    }
  } catch (const parmesan::FileError&) {
  }
  for (const auto& parse : {&parmesan::parse_sol, &parmesan::parse_solb}) {
    try {
      for (const auto& field : parse(bytes, "fuzz.sol").points) {
        if (field.values.size() % static_cast<std::size_t>(field.components) != 0) __builtin_trap();
      }
    } catch (const parmesan::FileError&) {
    }
  }
  return 0;
}
