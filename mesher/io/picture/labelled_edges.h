#pragma once

#include <string>
#include <vector>

#include "mesher/io/picture/canvas.h"
#include "mesher/io/picture/view.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The edges of one label, in a colour of their own.
struct LabelledEdges {
  std::string name;
  std::string colour;
  PicturePath path;
};

/// The labelled edges of a mesh, by label. The colours (M. Okabe, K. Ito, 2008) can be told apart by the colour-blind;
/// from the ninth label on they come again. Cost: O(edges log labels).
std::vector<LabelledEdges> labelled_edges(const Mesh& mesh, const View& view);

/// The height of a legend of so many pixels in width.
double legend_height(const std::vector<LabelledEdges>& edges, double width);

/// Draws the names beside lines of their colours, row after row from the upper left corner.
void draw_legend(Canvas& canvas, const std::vector<LabelledEdges>& edges, const Point& corner, double width);

}  // namespace parmesan
