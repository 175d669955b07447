#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/medit.h"

/// Any bytes are a Medit mesh, a metric, or a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const parmesan::Mesh mesh = parmesan::parse_medit(text, "fuzz.mesh");
    if (mesh.labels.size() != mesh.edges.size() || mesh.regions.size() != mesh.triangles.size()) __builtin_trap();
    for (const auto& triangle : mesh.triangles) {
      for (const int vertex : triangle) {
        if (vertex < 0 || vertex >= mesh.num_vertices()) __builtin_trap();
      }
    }
  } catch (const parmesan::FileError&) {
  }
  try {
    parmesan::parse_medit_metric(text, "fuzz.sol");
  } catch (const parmesan::FileError&) {
  }
  return 0;
}
