#pragma once

#include <string>

#include "mesher/io/picture/mesh_picture.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Writes a picture of the mesh (see draw_mesh) as SVG 1.1. Errors: as picture_layout; FileError.
void write_svg(const std::string& path, const Mesh& mesh, const PictureOptions& options = {});

}  // namespace parmesan
