#pragma once

#include <string>

#include "mesher/io/mesh_file.h"

namespace parmesan {

/// Throws FileError unless write_any_mesh knows the suffix.
void check_any_mesh_name(const std::string& path);

/// Writes a mesh with its fields in any format: those of write_mesh_file, and as a picture .png.
/// Errors: as write_mesh_file and write_png.
void write_any_mesh(const std::string& path, const Mesh& mesh, const MeshFields& fields = {},
                    const WriteOptions& options = {});

}  // namespace parmesan
