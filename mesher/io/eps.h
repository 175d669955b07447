#pragma once

#include <string>

#include "mesher/io/picture/mesh_picture.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Writes a picture of the mesh (see draw_mesh) as Encapsulated PostScript 3.0, level 2: one point per pixel.
/// PostScript has no transparency: lines that should shine through are drawn thinner. Characters of titles beyond ASCII
/// become question marks. Errors: as picture_layout; FileError.
void write_eps(const std::string& path, const Mesh& mesh, const PictureOptions& options = {});

}  // namespace parmesan
