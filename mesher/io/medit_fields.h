#pragma once

#include <string>
#include <string_view>

#include "mesher/io/mesh_fields.h"

namespace parmesan {

/// Reads all fields of a Medit solution: SolAtVertices and SolAtTriangles, of type 1 (scalar), 2 (vector) or 3
/// (symmetric tensor). The format has no names: fields are called by the name of the file, and by their number where
/// there are several. The suffix tells .sol (text) from .solb (binary).
/// Errors: FileError with the line or the byte; in dimension 3 for tensors, and vectors that leave the plane.
/// FileValueError where a number is not finite.
MeshFields read_medit_fields(const std::string& path);
MeshFields parse_sol(std::string_view text, const std::string& name);
MeshFields parse_solb(std::string_view bytes, const std::string& name);

/// Writes all fields to .sol or .solb. Errors: FileError, also for numbers that are not finite.
void write_medit_fields(const std::string& path, const MeshFields& fields);

}  // namespace parmesan
