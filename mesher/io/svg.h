#pragma once

#include <span>
#include <string>

#include "mesher/mesh.h"

namespace parmesan {

/// What a picture of a mesh shows.
struct SvgOptions {
  std::span<const double> values;  // one number per vertex to colour by; empty: no colours
  std::string title;
  std::string values_name;  // beside the colour bar
  int width_px = 900;       // of the whole picture, 200 to 20000
  bool show_edges = true;   // the triangles' sides; the boundary is always drawn
  bool show_axes = true;    // ticks with coordinates around the picture
  int num_colours = 48;     // bands of equal values, 2 to 256
};

/// Writes a picture of the mesh. Lines are as thin as the triangles beside them ask for, labelled
/// edges thicker; the colours fill the exact bands of the piecewise linear function.
/// Errors: InputError for values of another number than the vertices, not finite ones, or options
/// out of range; FileError.
void write_svg(const std::string& path, const Mesh& mesh, const SvgOptions& options = {});

}  // namespace parmesan
