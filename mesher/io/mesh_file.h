#pragma once

#include <string>

#include "mesher/io/mesh_fields.h"
#include "mesher/io/msh.h"

namespace parmesan {

/// Throws FileError unless write_mesh_file knows the suffix.
void check_mesh_file_name(const std::string& path);

/// Writes a mesh with its fields in the format that the suffix names.
///
/// .mesh, .meshb (Medit): fields go to .sol or .solb beside it; .msh (Gmsh 4.1); .vtu (VTK); .node, .ele (Triangle:
/// PATH.node, PATH.ele and PATH.edge) and .poly (the domain of the mesh, see domain_of) without fields; .svg, .eps
/// (pictures, coloured by the first scalar field at vertices). encoding: of .msh, the only format that has both.
/// Errors: InputError when a field has not one value per entity; FileError.
void write_mesh_file(const std::string& path, const Mesh& mesh, const MeshFields& fields = {},
                     Encoding encoding = Encoding::Text);

/// Reads a mesh in the format that the suffix names: .mesh, .meshb, .msh, or .node or .ele (reads both, and .edge
/// where there is one). Errors: FileError with the line or the byte.
Mesh read_mesh_file(const std::string& path);

/// The same with the fields of the file; those of .mesh and .meshb are looked for in .sol and .solb beside them.
/// Errors: FileError, also where there are not as many values as vertices or triangles.
MeshData read_mesh_data(const std::string& path);

/// Reads a mesh that can be computed on: boundary sides without an edge get one (see cover_boundary).
/// Errors: as read_mesh_file and validate.
Mesh read_valid_mesh(const std::string& path);

}  // namespace parmesan
