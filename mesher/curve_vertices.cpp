#include "mesher/curve_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesher/edge_finder.h"
#include "mesher/errors.h"
#include "mesher/geometry/predicates.h"
#include "mesher/geometry/segment_contacts.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

const Segment& segment_of(const Mesh& mesh, const Domain& domain, int edge) {
  return domain.segments[at(mesh.labels[at(edge)])];
}

// The point of the curve that is nearest to the chord's midpoint, which divides the arc about evenly.
Point middle_of_arc(const Domain& domain, const Segment& segment, const Point& a, const Point& b) {
  const auto [low, high] = std::minmax({parameter_on(domain, segment, a), parameter_on(domain, segment, b)});
  const double t = parameter_on(domain, segment, midpoint(a, b));
  return point_on(domain, segment, t > low && t < high ? t : 0.5 * (low + high));
}

/// The edges on curves, and how far each is from its own.
struct Deviations {
  std::vector<std::array<int, 2>> edges;
  std::vector<double> distances;
};

Deviations deviations_from_curves(const Mesh& mesh, const Domain& domain) {
  Deviations deviations;
  for (int e = 0; e < mesh.num_edges(); ++e) {
    const Segment& segment = segment_of(mesh, domain, e);
    if (segment.is_straight()) continue;
    const auto& [a, b] = mesh.edges[at(e)];
    const auto [from, to] = std::minmax(
        {parameter_on(domain, segment, mesh.points[at(a)]), parameter_on(domain, segment, mesh.points[at(b)])});
    deviations.edges.push_back(mesh.edges[at(e)]);
    deviations.distances.push_back(domain.curves[at(segment.curve)].deviation(from, to));
  }
  return deviations;
}

// Pairs of edges between the same two vertices.
std::vector<std::array<int, 2>> repeated_edges(const Mesh& mesh) {
  std::vector<std::array<int, 3>> sorted;
  for (int e = 0; e < mesh.num_edges(); ++e) {
    const auto [low, high] = std::minmax(mesh.edges[at(e)][0], mesh.edges[at(e)][1]);
    sorted.push_back({low, high, e});
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::array<int, 2>> pairs;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i][0] == sorted[i - 1][0] && sorted[i][1] == sorted[i - 1][1])
      pairs.push_back({sorted[i - 1][2], sorted[i][2]});
  return pairs;
}

}  // namespace

std::vector<EdgeMiddle> middles_on_curves(const Mesh& mesh, const Domain& domain) {
  std::vector<EdgeMiddle> middles;
  if (!has_curves(domain)) return middles;
  for (int e = 0; e < mesh.num_edges(); ++e) {
    const Segment& segment = segment_of(mesh, domain, e);
    if (segment.is_straight()) continue;
    const auto& [a, b] = mesh.edges[at(e)];
    middles.push_back({e, middle_of_arc(domain, segment, mesh.points[at(a)], mesh.points[at(b)])});
  }
  return middles;
}

std::optional<Mesh> put_on_curves(Mesh mesh, const Domain& domain) {
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  bool has_moved = false;
  for (int e = 0; e < mesh.num_edges(); ++e) {
    const Segment& segment = segment_of(mesh, domain, e);
    if (segment.is_straight()) continue;
    for (const int v : mesh.edges[at(e)]) {
      Point& p = mesh.points[at(v)];
      const Point place = point_on(domain, segment, parameter_on(domain, segment, p));
      if (norm(place - p) <= rounding * domain.curves[at(segment.curve)].extent()) continue;
      p = place;
      has_moved = true;
    }
  }
  const auto is_positive = [&mesh](const auto& t) {
    return orient2d(mesh.points[at(t[0])], mesh.points[at(t[1])], mesh.points[at(t[2])]) > 0.0;
  };
  if (has_moved && !std::all_of(mesh.triangles.begin(), mesh.triangles.end(), is_positive)) return std::nullopt;
  return mesh;
}

std::optional<std::string> distant_chords(const Mesh& mesh, const Domain& domain) {
  constexpr double much = 0.5;
  const Deviations deviations = deviations_from_curves(mesh, domain);
  if (deviations.edges.empty()) return std::nullopt;
  const EdgeFinder finder(deviations.edges, mesh.points.size());
  int count = 0;
  double worst = much;  // over the height
  Point place;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int edge = finder.find(t[k], t[(k + 1) % 3]);
      if (edge < 0) continue;
      const Point &a = mesh.points[at(t[k])], &b = mesh.points[at(t[(k + 1) % 3])];
      const double ratio =
          deviations.distances[at(edge)] * norm(b - a) / doubled_area(a, b, mesh.points[at(t[(k + 2) % 3])]);
      if (ratio <= much) continue;
      ++count;
      if (ratio > worst) place = midpoint(a, b);
      worst = std::max(worst, ratio);
    }
  }
  if (count == 0) return std::nullopt;
  return std::to_string(count) + (count > 1 ? " edges are" : " edge is") + " far from the curve, the worst by " +
         text(worst, 3) + " of the height of the triangle beside it, near " + text(place, 3) +
         ": the mesh is not as thin as the domain there; smaller sizes help";
}

void require_no_crossings(const Mesh& mesh, const Domain& domain) {
  if (!has_curves(domain)) return;
  std::vector<Segment> edges;
  for (const auto& [a, b] : mesh.edges) edges.push_back({a, b});
  std::vector<std::array<int, 2>> faults = segment_crossings(mesh.points, edges);
  const std::vector<std::array<int, 2>> doubled = repeated_edges(mesh);
  faults.insert(faults.end(), doubled.begin(), doubled.end());
  if (faults.empty()) return;
  const Point& p = mesh.points[at(edges[at(faults.front()[0])].a)];
  throw MeshingError("edges on curves cross near " + rounded_text(p) +
                     ", or lie on one another: the curves are nearer to one another than the edges are to them; ask "
                     "for smaller sizes there");
}

}  // namespace parmesan
