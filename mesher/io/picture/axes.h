#pragma once

#include <string>

#include "mesher/io/picture/canvas.h"
#include "mesher/io/picture/value_bands.h"
#include "mesher/io/picture/view.h"

namespace parmesan {

/// Draws the two axes with ticks and coordinates, a little to the left of and below the mesh.
void draw_axes(Canvas& canvas, const View& view);

/// A colour bar: its upper left corner and its height, in pixels, and how many colours it has.
struct ColourBar {
  Point corner;
  double height = 0.0;
  int num_colours = 1;
  std::string name;
};

/// Draws the colour bar with ticks to its right and the name above.
void draw_colour_bar(Canvas& canvas, const ColourBar& bar, ValueRange range);

}  // namespace parmesan
