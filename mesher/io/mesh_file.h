#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/io/mesh_fields.h"
#include "mesher/io/msh.h"
#include "mesher/io/picture/mesh_picture.h"

namespace parmesan {

/// What write_mesh_file writes, by suffix.
inline constexpr std::string_view written_suffixes = ".mesh .meshb .msh .vtu .svg .eps .node .ele .poly";

/// Does write_mesh_file know the suffix?
bool is_written_mesh_file_name(const std::string& path);

/// Throws FileError unless it does.
void check_mesh_file_name(const std::string& path);

/// What depends on the format.
struct WriteOptions {
  Encoding encoding = Encoding::Text;  // of .msh, the only format that has both
  PictureOptions picture = {};         // but for values and metrics, which fields give
  bool show_metrics = false;           // in pictures: the first symmetric tensor field at vertices, as ellipses
};

/// A picture of a mesh with its fields: coloured by the first scalar field at vertices, with ellipses when these are
/// asked for. Calls draw(options), which must not keep them. Errors: InputError for tensors that are no metrics.
void draw_with_fields(const MeshFields& fields, const WriteOptions& options,
                      const std::function<void(const PictureOptions&)>& draw);

/// Writes a mesh with its fields in the format that the suffix names.
///
/// .mesh, .meshb (Medit): fields go to .sol or .solb beside it; .msh (Gmsh 4.1); .vtu (VTK); .node, .ele (Triangle:
/// PATH.node, PATH.ele and PATH.edge) and .poly (the domain of the mesh, see domain_of) without fields; .svg, .eps
/// (pictures, see draw_with_fields).
/// Errors: InputError when a field has not one value per entity; FileError.
void write_mesh_file(const std::string& path, const Mesh& mesh, const MeshFields& fields = {},
                     const WriteOptions& options = {});

/// Reads a mesh in the format that the suffix names: .mesh, .meshb, .msh, or .node or .ele (reads both, and .edge
/// where there is one; a .node alone is points). A mesh seen from below, all of its triangles clockwise, is turned.
/// Errors: FileError with the line or the byte; FileValueError where a number is not finite or refers to nothing.
Mesh read_mesh_file(const std::string& path);

/// The same with the fields of the file; those of .mesh and .meshb are looked for in .sol and .solb beside them.
/// Notes tell of those that are older than the mesh by a second or more.
/// Errors: as read_mesh_file; FileError, too, where there are not as many values as vertices or triangles.
MeshData read_mesh_data(const std::string& path);

/// What readers of a file that has been written so will miss or mistake, one sentence each: fields and edges that
/// Triangle's files do not hold, and a .sol or .solb beside a .mesh or .meshb without fields. Cost: O(n).
std::vector<std::string> notes_on_written(const std::string& path, const Mesh& mesh, const MeshFields& fields = {});

/// Reads a mesh that can be computed on: boundary sides without an edge get one (see cover_boundary).
/// Errors: as read_mesh_file and validate.
Mesh read_valid_mesh(const std::string& path);

}  // namespace parmesan
