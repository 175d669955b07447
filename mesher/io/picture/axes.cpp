#include "mesher/io/picture/axes.h"

#include <algorithm>

#include "mesher/io/picture/colour_map.h"
#include "mesher/io/picture/svg_text.h"
#include "mesher/io/picture/ticks.h"

namespace parmesan {
namespace {

constexpr double axis_gap = 8.0;  // between the mesh and its axes; all lengths in pixels
constexpr double tick_length = 4.0;
constexpr double bar_width = 14.0;

constexpr char axis_group[] = "<g stroke=\"#6b7280\" fill=\"none\">\n";

/// About one tick per spacing pixels.
int num_ticks(double length, double spacing) { return std::clamp(static_cast<int>(length / spacing) + 1, 5, 12); }

void write_horizontal_axis(OutputFile& out, const View& view) {
  const double y = view.corner.y + axis_gap;
  const auto ticks = nice_ticks(view.bounds.low.x, view.bounds.high.x, num_ticks(view.width(), 70.0));
  out << axis_group;
  write_line(out, {view.corner.x, y}, {view.corner.x + view.width(), y});
  const auto x = [&view](const Tick& tick) { return view({tick.value, view.bounds.low.y}).x; };
  for (const Tick& tick : ticks) write_line(out, {x(tick), y}, {x(tick), y + tick_length});
  out << "</g>\n<g text-anchor=\"middle\">\n";
  for (const Tick& tick : ticks) write_text(out, {x(tick), y + tick_length + 12.0}, "", tick.label);
  out << "</g>\n";
}

void write_vertical_axis(OutputFile& out, const View& view) {
  const double x = view.corner.x - axis_gap;
  const auto ticks = nice_ticks(view.bounds.low.y, view.bounds.high.y, num_ticks(view.height(), 50.0));
  out << axis_group;
  write_line(out, {x, view.corner.y}, {x, view.corner.y - view.height()});
  const auto y = [&view](const Tick& tick) { return view({view.bounds.low.x, tick.value}).y; };
  for (const Tick& tick : ticks) write_line(out, {x, y(tick)}, {x - tick_length, y(tick)});
  out << "</g>\n<g text-anchor=\"end\">\n";
  for (const Tick& tick : ticks) write_text(out, {x - tick_length - 3.0, y(tick) + 4.0}, "", tick.label);
  out << "</g>\n";
}

void write_colours(OutputFile& out, const ColourBar& bar) {
  const double part = bar.height / bar.num_colours;
  out << "<g shape-rendering=\"crispEdges\">\n";
  for (int i = 0; i < bar.num_colours; ++i) {
    out << "<rect x=\"";
    write_pixels(out, bar.corner.x);
    out << "\" y=\"";
    write_pixels(out, bar.corner.y + bar.height - (i + 1) * part);
    out << "\" width=\"" << bar_width << "\" height=\"";
    write_pixels(out, i == 0 ? part : part + 0.5);  // overlaps the one below, so that no gap shows
    out << "\" fill=\"" << colour_at((i + 0.5) / bar.num_colours) << "\"/>\n";
  }
  out << "</g>\n";
}

}  // namespace

void write_axes(OutputFile& out, const View& view) {
  write_horizontal_axis(out, view);
  write_vertical_axis(out, view);
}

void write_colour_bar(OutputFile& out, const ColourBar& bar, ValueRange range) {
  write_colours(out, bar);
  const double x = bar.corner.x + bar_width;
  const auto ticks = nice_ticks(range.low, range.high, num_ticks(bar.height, 40.0));
  const auto y = [&bar, range](const Tick& tick) {
    return bar.corner.y + bar.height * (1.0 - fraction(range, tick.value));
  };
  out << axis_group;
  for (const Tick& tick : ticks) write_line(out, {x, y(tick)}, {x + tick_length, y(tick)});
  out << "</g>\n";
  for (const Tick& tick : ticks) write_text(out, {x + tick_length + 3.0, y(tick) + 4.0}, "", tick.label);
  write_text(out, {bar.corner.x, bar.corner.y - 8.0}, "", bar.name);
}

}  // namespace parmesan
