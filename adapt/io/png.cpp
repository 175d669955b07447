#include "adapt/io/png.h"

#include <cairo.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <new>

#include "mesher/errors.h"
#include "mesher/io/output_file.h"

namespace parmesan {
namespace {

struct Deleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, Deleter>;
using Context = std::unique_ptr<cairo_t, Deleter>;

/// Errors: std::bad_alloc, or InputError for what else Cairo could not do.
void require_success(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw InputError(std::string("no PNG picture: ") + cairo_status_to_string(status));
}

class CairoCanvas : public Canvas {
 public:
  CairoCanvas(cairo_surface_t* surface, double resolution) : context_(cairo_create(surface)) {
    cairo_scale(pen(), resolution, resolution);
    cairo_set_line_join(pen(), CAIRO_LINE_JOIN_ROUND);
  }

  cairo_status_t status() const { return cairo_status(pen()); }

  // Polygon by polygon: as one path their inner sides would have to be found and cancelled.
  void fill(const PicturePath& path, const std::string& colour) override {
    set_colour(colour, 1.0);
    cairo_set_line_width(pen(), 1.0);
    for (const PicturePath::Step& step : path.steps()) {
      follow(step);
      if (step.command != PicturePath::Command::Close) continue;
      cairo_fill_preserve(pen());
      cairo_stroke(pen());
    }
  }

  void stroke(const PicturePath& path, const Pen& with) override {
    constexpr std::size_t longest_path = 1000;  // the rasterizer's time grows faster than the path
    set_colour(with.colour, with.opacity);
    cairo_set_line_width(pen(), with.width_px);
    cairo_set_line_cap(pen(), with.has_round_ends ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    std::size_t size = 0;
    for (const PicturePath::Step& step : path.steps()) {
      const bool is_long = size >= longest_path && step.command == PicturePath::Command::MoveTo;
      if (is_long) cairo_stroke(pen());
      size = is_long ? 1 : size + 1;
      follow(step);
    }
    cairo_stroke(pen());
  }

  void rectangle(const Point& corner, double width, double height, const std::string& colour) override {
    set_colour(colour, 1.0);
    cairo_rectangle(pen(), corner.x, corner.y, width, height);
    cairo_fill(pen());
  }

  void text(const Point& at, std::string_view text, const TextStyle& style) override {
    const std::string words(text);
    set_colour(style.colour, 1.0);
    cairo_select_font_face(pen(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           style.is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(pen(), style.size_px);
    cairo_text_extents_t extents;
    cairo_text_extents(pen(), words.c_str(), &extents);
    const double shift = style.anchor == TextStyle::Anchor::Start ? 0.0
                         : style.anchor == TextStyle::Anchor::End ? extents.x_advance
                                                                  : 0.5 * extents.x_advance;
    cairo_move_to(pen(), at.x - shift, at.y);
    cairo_show_text(pen(), words.c_str());
    cairo_new_path(pen());
  }

 private:
  cairo_t* pen() const { return context_.get(); }

  /// From "#rrggbb".
  void set_colour(const std::string& colour, double opacity) {
    unsigned value = 0;
    std::from_chars(colour.data() + 1, colour.data() + colour.size(), value, 16);
    const auto part = [value](unsigned shift) { return static_cast<double>((value >> shift) & 0xffU) / 255.0; };
    cairo_set_source_rgba(pen(), part(16), part(8), part(0), opacity);
  }

  void follow(const PicturePath::Step& step) {
    if (step.command == PicturePath::Command::MoveTo) cairo_move_to(pen(), 0.01 * step.x, 0.01 * step.y);
    if (step.command == PicturePath::Command::LineTo) cairo_line_to(pen(), 0.01 * step.x, 0.01 * step.y);
    if (step.command == PicturePath::Command::Close) cairo_close_path(pen());
  }

  Context context_;
};

// For cairo_surface_write_to_png_stream: an exception must not go through C.
cairo_status_t append(void* file, const unsigned char* bytes, unsigned int count) {
  try {
    *static_cast<OutputFile*>(file) << std::string_view(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
  } catch (const FileError&) {
    return CAIRO_STATUS_WRITE_ERROR;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

}  // namespace

void write_png(const std::string& path, const Mesh& mesh, const PictureOptions& options, double resolution) {
  constexpr double most_pixels = 32767.0;  // Cairo's limit
  const PictureLayout layout = picture_layout(mesh, options);
  const double width = std::ceil(resolution * layout.width);
  const double height = std::ceil(resolution * layout.height);
  if (!(width <= most_pixels && height <= most_pixels && width >= 1.0 && height >= 1.0))
    throw InputError("a PNG picture may have 32767 pixels a side at most");
  OutputFile out(path);
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  require_success(cairo_surface_status(surface.get()));
  CairoCanvas canvas(surface.get(), resolution);
  draw_mesh(canvas, mesh, layout, options);
  require_success(canvas.status());
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append, &out);
  if (status == CAIRO_STATUS_WRITE_ERROR) throw FileError(path, 0, cairo_status_to_string(status));
  require_success(status);
  out.commit();
}

}  // namespace parmesan
