#include "mesher/io/svg.h"

#include <algorithm>
#include <cmath>

#include "mesher/errors.h"
#include "mesher/io/output_file.h"
#include "mesher/io/picture/axes.h"
#include "mesher/io/picture/colour_map.h"
#include "mesher/io/picture/side_classes.h"
#include "mesher/io/picture/svg_path.h"
#include "mesher/io/picture/svg_text.h"
#include "mesher/io/picture/value_bands.h"
#include "mesher/io/picture/view.h"

namespace parmesan {
namespace {

/// Where the mesh, and what stands around it, lie in the picture.
struct Layout {
  View view;
  double width = 0.0;  // of the picture, in pixels
  double height = 0.0;
};

Layout layout_of(const Mesh& mesh, const SvgOptions& options) {
  const double left = options.show_axes ? 58.0 : 12.0;
  const double bottom = options.show_axes ? 36.0 : 12.0;
  const double right = options.values.empty() ? 14.0 : 96.0;
  const bool has_header = !options.title.empty() || !options.values_name.empty();
  const double top = has_header ? 44.0 : 14.0;
  Layout layout;
  layout.width = options.width_px;
  layout.view.bounds = bounds_of(mesh);
  const Vector extent = layout.view.bounds.high - layout.view.bounds.low;
  const double room_x = std::max(layout.width - left - right, 20.0);
  const double room_y = 1.5 * layout.width;  // tall domains are drawn narrower than the picture
  const double scale = std::min(room_x / extent.x, room_y / extent.y);
  layout.view.scale = std::isfinite(scale) ? scale : 1.0;  // not for a mesh that is a point
  layout.height = top + layout.view.height() + bottom;
  layout.view.corner = {left + 0.5 * (room_x - layout.view.width()), top + layout.view.height()};
  return layout;
}

void check(const Mesh& mesh, const SvgOptions& options) {
  if (!options.values.empty() && options.values.size() != mesh.points.size()) {
    throw InputError("a picture needs one value per vertex, has " + std::to_string(options.values.size()) + " for " +
                     std::to_string(mesh.points.size()));
  }
  if (options.width_px < 200 || options.width_px > 20000) throw InputError("width_px must be from 200 to 20000");
  if (options.num_colours < 2 || options.num_colours > 256) throw InputError("num_colours must be from 2 to 256");
}

void write_head(OutputFile& out, const Layout& layout, const SvgOptions& options) {
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << options.width_px << "\" height=\"";
  write_pixels(out, layout.height);
  out << "\" viewBox=\"0 0 " << options.width_px << ' ';
  write_pixels(out, layout.height);
  out << "\" font-family=\"Helvetica,Arial,sans-serif\" font-size=\"11\" fill=\"#374151\">\n";
  out << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  if (options.title.empty()) return;
  write_text(out, {layout.view.corner.x, 22.0}, "font-size=\"15\" font-weight=\"600\" fill=\"#111827\"", options.title);
}

void write_path(OutputFile& out, const SvgPath& path, const char* attribute, std::string_view value) {
  if (!path.empty()) out << "<path " << attribute << "=\"" << value << "\" d=\"" << path.data() << "\"/>\n";
}

// A band's line in its own colour covers the seams that antialiasing leaves between polygons.
void write_bands(OutputFile& out, const Mesh& mesh, const View& view, const SvgOptions& options, ValueRange range) {
  const auto bands = value_bands(mesh, view, options.values, range, options.num_colours);
  out << "<g transform=\"scale(.01)\" stroke-width=\"100\" stroke-linejoin=\"round\">\n";
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const std::string colour = colour_at((static_cast<double>(i) + 0.5) / static_cast<double>(bands.size()));
    write_path(out, bands[i], ("stroke=\"" + colour + "\" fill").c_str(), colour);
  }
  out << "</g>\n";
}

void write_sides(OutputFile& out, const Mesh& mesh, const View& view, bool coloured) {
  out << "<g transform=\"scale(.01)\" fill=\"none\" stroke=\"" << (coloured ? "#000\" stroke-opacity=\".35" : "#334155")
      << "\">\n";
  for (const SideClass& sides : side_classes(mesh, view)) {
    out << "<path stroke-width=\"";
    write_pixels(out, 100.0 * sides.width_px);
    out << "\" d=\"" << sides.path.data() << "\"/>\n";
  }
  out << "</g>\n";
}

void write_edges(OutputFile& out, const Mesh& mesh, const View& view) {
  SvgPath path;
  for (const auto& [a, b] : mesh.edges) {
    path.move_to(view(mesh.points[static_cast<std::size_t>(a)]));
    path.line_to(view(mesh.points[static_cast<std::size_t>(b)]));
  }
  out << "<g transform=\"scale(.01)\" fill=\"none\" stroke=\"#0f172a\" stroke-linecap=\"round\">\n";
  write_path(out, path, "stroke-width", "130");
  out << "</g>\n";
}

}  // namespace

void write_svg(const std::string& path, const Mesh& mesh, const SvgOptions& options) {
  check(mesh, options);
  const ValueRange range = range_of(options.values);
  const Layout layout = layout_of(mesh, options);
  OutputFile out(path);
  write_head(out, layout, options);
  const bool coloured = !options.values.empty();
  if (coloured) write_bands(out, mesh, layout.view, options, range);
  if (options.show_edges) write_sides(out, mesh, layout.view, coloured);
  write_edges(out, mesh, layout.view);
  if (options.show_axes) write_axes(out, layout.view);
  if (coloured) {
    const double height = std::max(layout.view.height(), 60.0);
    const Point corner{layout.width - 76.0, layout.view.corner.y - layout.view.height()};
    write_colour_bar(out, {corner, height, options.num_colours, options.values_name}, range);
  }
  out << "</svg>\n";
  out.commit();
}

}  // namespace parmesan
