#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/msh.h"

/// Any bytes are a Gmsh mesh with fields, or an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const parmesan::MeshData read = parmesan::parse_msh(bytes, "fuzz.msh");
    const parmesan::Mesh& mesh = read.mesh;
    if (mesh.labels.size() != mesh.edges.size() || mesh.regions.size() != mesh.triangles.size()) __builtin_trap();
    for (const auto& triangle : mesh.triangles) {
      for (const int vertex : triangle) {
        if (vertex < 0 || vertex >= mesh.num_vertices()) __builtin_trap();
      }
    }
    parmesan::check_fields(read.fields, mesh);
  } catch (const parmesan::InputError&) {
  }
  return 0;
}
