#include "mesher/io/picture/mesh_picture.h"

#include <algorithm>
#include <cmath>

#include "mesher/errors.h"
#include "mesher/index.h"
#include "mesher/io/picture/axes.h"
#include "mesher/io/picture/colour_map.h"
#include "mesher/io/picture/labelled_edges.h"
#include "mesher/io/picture/metric_ellipses.h"
#include "mesher/io/picture/side_classes.h"
#include "mesher/io/picture/value_bands.h"

namespace parmesan {
namespace {

void check(const Mesh& mesh, const PictureOptions& options) {
  if (!options.values.empty() && options.values.size() != mesh.points.size()) {
    throw InputError("a picture needs one value per vertex, has " + std::to_string(options.values.size()) + " for " +
                     std::to_string(mesh.points.size()));
  }
  if (!options.metrics.empty() && options.metrics.size() != mesh.points.size())
    throw InputError("a picture needs one metric per vertex");
  if (options.width_px < 200 || options.width_px > 20000) throw InputError("width_px must be from 200 to 20000");
  if (options.num_colours < 2 || options.num_colours > 256) throw InputError("num_colours must be from 2 to 256");
  range_of(options.values);
}

void draw_bands(Canvas& canvas, const Mesh& mesh, const View& view, const PictureOptions& options) {
  const auto bands = value_bands(mesh, view, options.values, range_of(options.values), options.num_colours);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    canvas.fill(bands[i], colour_at((static_cast<double>(i) + 0.5) / static_cast<double>(bands.size())));
  }
}

void draw_sides(Canvas& canvas, const Mesh& mesh, const View& view, bool coloured) {
  for (const SideClass& sides : side_classes(mesh, view)) {
    canvas.stroke(sides.path, {coloured ? "#000000" : "#334155", sides.width_px, coloured ? 0.35 : 1.0, false});
  }
}

void draw_labels(Canvas& canvas, const Mesh& mesh, const PictureLayout& layout) {
  const std::vector<LabelledEdges> edges = labelled_edges(mesh, layout.view);
  for (const LabelledEdges& of_label : edges) canvas.stroke(of_label.path, {of_label.colour, 2.2, 1.0, true});
  const double left = layout.view.corner.x;
  draw_legend(canvas, edges, {left, layout.height - layout.legend}, layout.width - left);
}

void draw_edges(Canvas& canvas, const Mesh& mesh, const View& view) {
  PicturePath path;
  for (const auto& [a, b] : mesh.edges) {
    path.move_to(view(mesh.points[at(a)]));
    path.line_to(view(mesh.points[at(b)]));
  }
  canvas.stroke(path, {"#0f172a", 1.3, 1.0, true});
}

}  // namespace

PictureLayout picture_layout(const Mesh& mesh, const PictureOptions& options) {
  check(mesh, options);
  const double left = options.show_axes ? 58.0 : 12.0;
  const double bottom = options.show_axes ? 36.0 : 12.0;
  const double right = options.values.empty() ? 14.0 : 96.0;
  const bool has_header = !options.title.empty() || !options.values_name.empty();
  const double top = has_header ? 44.0 : 14.0;
  PictureLayout layout;
  layout.width = options.width_px;
  layout.view.bounds = bounds_of(mesh);
  const Vector extent = layout.view.bounds.high - layout.view.bounds.low;
  const double room_x = std::max(layout.width - left - right, 20.0);
  const double room_y = 1.5 * layout.width;  // tall domains are drawn narrower than the picture
  const double scale = std::min(room_x / extent.x, room_y / extent.y);
  layout.view.scale = std::isfinite(scale) ? scale : 1.0;  // not for a mesh that is a point
  layout.view.corner = {left + 0.5 * (room_x - layout.view.width()), top + layout.view.height()};
  if (options.show_labels)
    layout.legend = legend_height(labelled_edges(mesh, layout.view), layout.width - layout.view.corner.x);
  layout.height = top + layout.view.height() + bottom + layout.legend;
  return layout;
}

void draw_mesh(Canvas& canvas, const Mesh& mesh, const PictureLayout& layout, const PictureOptions& options) {
  const View& view = layout.view;
  canvas.rectangle({0.0, 0.0}, layout.width, layout.height, "#ffffff");
  if (!options.title.empty()) {
    canvas.text({view.corner.x, 22.0}, options.title, {TextStyle::Anchor::Start, 15.0, true, "#111827"});
  }
  const bool coloured = !options.values.empty();
  if (coloured) draw_bands(canvas, mesh, view, options);
  if (options.show_edges) draw_sides(canvas, mesh, view, coloured);
  if (!options.metrics.empty())
    canvas.stroke(metric_ellipses(mesh, view, options.metrics), {"#b91c1c", 0.9, 1.0, false});
  if (options.show_labels)
    draw_labels(canvas, mesh, layout);
  else
    draw_edges(canvas, mesh, view);
  if (options.show_axes) draw_axes(canvas, view);
  if (coloured) {
    const Point corner{layout.width - 76.0, view.corner.y - view.height()};
    const ColourBar bar{corner, std::max(view.height(), 60.0), options.num_colours, options.values_name};
    draw_colour_bar(canvas, bar, range_of(options.values));
  }
}

}  // namespace parmesan
