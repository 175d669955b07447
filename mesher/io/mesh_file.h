#pragma once

#include <string>

#include "mesher/mesh.h"

namespace parmesan {

/// Throws FileError unless write_mesh_file knows the suffix.
void check_mesh_file_name(const std::string& path);

/// Writes a mesh in the format that the suffix names: .mesh (Medit), .vtu (VTK), .svg (a picture),
/// .node or .ele (Triangle: writes PATH.node, PATH.ele and PATH.edge). Errors: FileError.
void write_mesh_file(const std::string& path, const Mesh& mesh);

/// Reads a mesh in the format that the suffix names: .mesh, or .node or .ele (reads both, and
/// .edge where there is one). Errors: FileError with the line.
Mesh read_mesh_file(const std::string& path);

}  // namespace parmesan
