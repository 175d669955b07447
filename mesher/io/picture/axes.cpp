#include "mesher/io/picture/axes.h"

#include <algorithm>

#include "mesher/io/picture/colour_map.h"
#include "mesher/io/picture/ticks.h"

namespace parmesan {
namespace {

constexpr double axis_gap = 8.0;  // between the mesh and its axes; all lengths in pixels
constexpr double tick_length = 4.0;
constexpr double bar_width = 14.0;

const Pen axis_pen{"#6b7280", 1.0, 1.0, false};

/// About one tick per spacing pixels.
int num_ticks(double length, double spacing) { return std::clamp(static_cast<int>(length / spacing) + 1, 5, 12); }

void add_line(PicturePath& path, const Point& from, const Point& to) {
  path.move_to(from);
  path.line_to(to);
}

void draw_horizontal_axis(Canvas& canvas, const View& view) {
  const double y = view.corner.y + axis_gap;
  const auto ticks = nice_ticks(view.bounds.low.x, view.bounds.high.x, num_ticks(view.width(), 70.0));
  const auto x = [&view](const Tick& tick) { return view({tick.value, view.bounds.low.y}).x; };
  PicturePath lines;
  add_line(lines, {view.corner.x, y}, {view.corner.x + view.width(), y});
  for (const Tick& tick : ticks) add_line(lines, {x(tick), y}, {x(tick), y + tick_length});
  canvas.stroke(lines, axis_pen);
  for (const Tick& tick : ticks) {
    canvas.text({x(tick), y + tick_length + 12.0}, tick.label, {.anchor = TextStyle::Anchor::Middle});
  }
}

void draw_vertical_axis(Canvas& canvas, const View& view) {
  const double x = view.corner.x - axis_gap;
  const auto ticks = nice_ticks(view.bounds.low.y, view.bounds.high.y, num_ticks(view.height(), 50.0));
  const auto y = [&view](const Tick& tick) { return view({view.bounds.low.x, tick.value}).y; };
  PicturePath lines;
  add_line(lines, {x, view.corner.y}, {x, view.corner.y - view.height()});
  for (const Tick& tick : ticks) add_line(lines, {x, y(tick)}, {x - tick_length, y(tick)});
  canvas.stroke(lines, axis_pen);
  for (const Tick& tick : ticks) {
    canvas.text({x - tick_length - 3.0, y(tick) + 4.0}, tick.label, {.anchor = TextStyle::Anchor::End});
  }
}

void draw_colours(Canvas& canvas, const ColourBar& bar) {
  const double part = bar.height / bar.num_colours;
  for (int i = 0; i < bar.num_colours; ++i) {
    const Point corner{bar.corner.x, bar.corner.y + bar.height - (i + 1) * part};
    const double height = i == 0 ? part : part + 0.5;  // overlaps the one below, so that no gap shows
    canvas.rectangle(corner, bar_width, height, colour_at((i + 0.5) / bar.num_colours));
  }
}

}  // namespace

void draw_axes(Canvas& canvas, const View& view) {
  draw_horizontal_axis(canvas, view);
  draw_vertical_axis(canvas, view);
}

void draw_colour_bar(Canvas& canvas, const ColourBar& bar, ValueRange range) {
  draw_colours(canvas, bar);
  const double x = bar.corner.x + bar_width;
  const auto ticks = nice_ticks(range.low, range.high, num_ticks(bar.height, 40.0));
  const auto y = [&bar, range](const Tick& tick) {
    return bar.corner.y + bar.height * (1.0 - fraction(range, tick.value));
  };
  PicturePath lines;
  for (const Tick& tick : ticks) add_line(lines, {x, y(tick)}, {x + tick_length, y(tick)});
  canvas.stroke(lines, axis_pen);
  for (const Tick& tick : ticks) canvas.text({x + tick_length + 3.0, y(tick) + 4.0}, tick.label, {});
  canvas.text({bar.corner.x, bar.corner.y - 8.0}, bar.name, {});
}

}  // namespace parmesan
