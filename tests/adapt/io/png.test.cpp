#include "adapt/io/png.h"

#include <cairo.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "mesher/errors.h"
#include "mesher/io/picture/colour_map.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;

namespace {

/// The pixels of a PNG file, as 0xrrggbb.
struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> rgb;
  std::uint32_t at(double x, double y) const {
    return rgb[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

Pixels read_png(const std::string& path) {
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy);
  REQUIRE(cairo_surface_status(surface.get()) == CAIRO_STATUS_SUCCESS);
  Pixels pixels{cairo_image_surface_get_width(surface.get()), cairo_image_surface_get_height(surface.get()), {}};
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < pixels.height; ++y)
    for (int x = 0; x < pixels.width; ++x)
      pixels.rgb.push_back(
          reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(surface.get()) + y * stride)[x] &
          0xffffffU);
  return pixels;
}

std::uint32_t number_of(const std::string& colour) {
  return static_cast<std::uint32_t>(std::strtoul(colour.c_str() + 1, nullptr, 16));
}

}  // namespace

TEST_CASE("a PNG shows each value's colour in its place, on white", "[adapt][io][picture]") {
  const support::TemporaryFolder folder;
  const Mesh mesh = support::rectangle_mesh(8, 8);
  std::vector<double> values;
  for (const Point& p : mesh.points) values.push_back(p.x);
  PictureOptions options;
  options.values = values;
  options.show_edges = false;
  options.num_colours = 16;
  const double resolution = GENERATE(1.0, 2.5);
  write_png(folder / "a.png", mesh, options, resolution);
  const PictureLayout layout = picture_layout(mesh, options);
  const Pixels pixels = read_png(folder / "a.png");
  CHECK(pixels.width == Approx(resolution * layout.width).margin(1.0));
  CHECK(pixels.height == Approx(resolution * layout.height).margin(1.0));
  CHECK(pixels.at(0, 0) == 0xffffffU);
  for (int band = 0; band < 16; ++band) {
    CAPTURE(band);
    const double t = (band + 0.5) / 16.0;
    const Point place = resolution * (layout.view({t, 0.37}) - Point{});
    CHECK(pixels.at(place.x, place.y) == number_of(colour_at(t)));
  }
}

TEST_CASE("a PNG too large, or in no folder, is refused and leaves nothing", "[adapt][io][picture][errors]") {
  const support::TemporaryFolder folder;
  const Mesh mesh = support::rectangle_mesh(2, 2);
  PictureOptions options;
  options.width_px = 20000;
  CHECK_THROWS_AS(write_png(folder / "a.png", mesh, options, 2.0), InputError);
  CHECK_THROWS_AS(write_png(folder / "none/a.png", mesh), FileError);
  CHECK(folder.num_files() == 0);
}
