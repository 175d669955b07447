#include "mesher/io/picture/labelled_edges.h"

#include <array>
#include <map>

#include "mesher/index.h"

namespace parmesan {
namespace {

constexpr std::array<const char*, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#000000", "#b3a300"};
constexpr double row_height = 18.0;  // all lengths in pixels
constexpr double line_length = 22.0;
constexpr double font_size = 11.0;

/// Where the entries of a legend go, from its corner; the last place is where one more would.
std::vector<Point> places_of(const std::vector<LabelledEdges>& edges, double width) {
  constexpr double width_of_character = 0.62 * font_size;
  std::vector<Point> places{{0.0, 0.0}};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double extent = line_length + 24.0 + width_of_character * static_cast<double>(edges[i].name.size());
    Point& place = places.back();
    if (place.x > 0.0 && place.x + extent > width) place = {0.0, place.y + row_height};
    places.push_back({place.x + extent, place.y});
  }
  return places;
}

}  // namespace

std::vector<LabelledEdges> labelled_edges(const Mesh& mesh, const View& view) {
  std::map<int, PicturePath> paths;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    PicturePath& path = paths[mesh.labels[i]];
    path.move_to(view(mesh.points[at(mesh.edges[i][0])]));
    path.line_to(view(mesh.points[at(mesh.edges[i][1])]));
  }
  std::vector<LabelledEdges> result;
  result.reserve(paths.size());
  for (auto& [label, path] : paths)
    result.push_back({label_name(mesh.label_names, label), colours[result.size() % colours.size()], std::move(path)});
  return result;
}

double legend_height(const std::vector<LabelledEdges>& edges, double width) {
  return edges.empty() ? 0.0 : places_of(edges, width).back().y + row_height;
}

void draw_legend(Canvas& canvas, const std::vector<LabelledEdges>& edges, const Point& corner, double width) {
  const std::vector<Point> places = places_of(edges, width);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Point at = corner + (places[i] - Point{});
    PicturePath line;
    line.move_to({at.x, at.y + 8.0});
    line.line_to({at.x + line_length, at.y + 8.0});
    canvas.stroke(line, {edges[i].colour, 3.0, 1.0, true});
    canvas.text({at.x + line_length + 7.0, at.y + 12.0}, edges[i].name, {.size_px = font_size});
  }
}

}  // namespace parmesan
