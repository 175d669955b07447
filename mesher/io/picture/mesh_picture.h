#pragma once

#include <span>
#include <string>

#include "mesher/io/picture/canvas.h"
#include "mesher/io/picture/view.h"
#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// What a picture of a mesh shows.
struct PictureOptions {
  std::span<const double> values;  // one number per vertex to colour by; empty: no colours
  std::string title;
  std::string values_name;               // beside the colour bar
  int width_px = 900;                    // of the whole picture, 200 to 20000
  bool show_edges = true;                // the triangles' sides; the boundary is always drawn
  bool show_axes = true;                 // ticks with coordinates around the picture
  bool show_labels = false;              // labelled edges in colours, with a legend
  std::span<const Metric> metrics = {};  // one per vertex, drawn as ellipses; empty: none
  int num_colours = 48;                  // bands of equal values, 2 to 256
};

/// Where the mesh, and what stands around it, lie in the picture.
struct PictureLayout {
  View view;
  double width = 0.0;  // of the picture, in pixels
  double height = 0.0;
  double legend = 0.0;  // what of it the legend below takes
};

/// Errors: InputError for values or metrics of another number than the vertices, values that are not finite, or options
/// out of range.
PictureLayout picture_layout(const Mesh& mesh, const PictureOptions& options);

/// Draws a mesh. Lines are as thin as the triangles beside them ask for, labelled edges thicker; the colours fill the
/// exact bands of the piecewise linear function.
void draw_mesh(Canvas& canvas, const Mesh& mesh, const PictureLayout& layout, const PictureOptions& options);

}  // namespace parmesan
