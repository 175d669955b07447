#pragma once

#include <string>

#include "mesher/io/picture/mesh_picture.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Writes a picture of the mesh (see draw_mesh) as PNG, drawn by Cairo, `resolution` pixels of the file for one of the
/// layout: 1 for screens, 2 to 4 for print. Errors: as picture_layout; InputError for a picture of over 32 767 pixels;
/// FileError. Memory: 4 bytes per pixel.
void write_png(const std::string& path, const Mesh& mesh, const PictureOptions& options = {}, double resolution = 2.0);

}  // namespace parmesan
