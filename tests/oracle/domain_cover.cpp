#include "tests/oracle/domain_cover.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "tests/oracle/exact_sign.h"

namespace parmesan::oracle {

namespace {

const Point& point(const Mesh& mesh, int v) { return mesh.points.at(static_cast<std::size_t>(v)); }

bool lies_in(const Mesh& mesh, const Point& p) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&mesh, &p](const auto& t) {
    const Point& a = point(mesh, t[0]);
    const Point& b = point(mesh, t[1]);
    const Point& c = point(mesh, t[2]);
    if (p.x < std::min({a.x, b.x, c.x}) || p.x > std::max({a.x, b.x, c.x})) return false;
    return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
  });
}

/// A domain segment with positions along it, 0 at its start and its length at its end.
struct Ruler {
  Point start;
  Point end;
  double length() const { return std::hypot(end.x - start.x, end.y - start.y); }
  double along(const Point& p) const {
    return ((p.x - start.x) * (end.x - start.x) + (p.y - start.y) * (end.y - start.y)) / length();
  }
  double off(const Point& p) const {
    return std::abs((end.x - start.x) * (p.y - start.y) - (end.y - start.y) * (p.x - start.x)) / length();
  }
  bool holds(const Point& p, double tolerance) const {
    return off(p) <= tolerance && along(p) >= -tolerance && along(p) <= length() + tolerance;
  }
};

/// The pieces of the ruler that edges of a label cover, sorted; with a direction (1: along the ruler, -1: against it)
/// only the edges that lead that way.
std::vector<std::pair<double, double>> covered(const Mesh& mesh, const Ruler& ruler, int label, int direction,
                                               double tolerance) {
  std::vector<std::pair<double, double>> pieces;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const Point& p = point(mesh, mesh.edges[e][0]);
    const Point& q = point(mesh, mesh.edges[e][1]);
    if (mesh.labels[e] != label || !ruler.holds(p, tolerance) || !ruler.holds(q, tolerance)) continue;
    const double step = ruler.along(q) - ruler.along(p);
    if (direction != 0 && (direction > 0) != (step > 0.0)) continue;
    pieces.push_back(std::minmax(ruler.along(p), ruler.along(q)));
  }
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

bool is_covered(const Mesh& mesh, const Ruler& ruler, int label, int direction, double tolerance) {
  double reached = 0.0;
  for (const auto& [from, to] : covered(mesh, ruler, label, direction, tolerance)) {
    if (std::abs(from - reached) > 2.0 * tolerance) return false;
    reached = to;
  }
  return std::abs(reached - ruler.length()) <= 2.0 * tolerance;
}

/// A crack is covered along both sides, each by edges with the domain to their left.
bool is_covered(const Mesh& mesh, const Ruler& ruler, const Segment& segment, double tolerance) {
  if (!segment.label_right) return is_covered(mesh, ruler, segment.label, 0, tolerance);
  return is_covered(mesh, ruler, segment.label, 1, tolerance) &&
         is_covered(mesh, ruler, *segment.label_right, -1, tolerance);
}

}  // namespace

std::vector<std::string> problems_of_cover(const Mesh& mesh, const Domain& domain, double tolerance) {
  std::vector<std::string> problems;
  std::set<std::pair<double, double>> vertices;
  for (const Point& p : mesh.points) vertices.emplace(p.x, p.y);
  for (std::size_t i = 0; i < domain.points.size(); ++i) {
    const Point& p = domain.points[i];
    if (vertices.count({p.x, p.y}) == 0 && lies_in(mesh, p)) {
      problems.push_back("point " + std::to_string(i) + " is not a vertex");
    }
  }
  std::vector<Ruler> rulers;
  for (std::size_t s = 0; s < domain.segments.size(); ++s) {
    const Segment& segment = domain.segments[s];
    const Ruler ruler{domain.points[static_cast<std::size_t>(segment.a)],
                      domain.points[static_cast<std::size_t>(segment.b)]};
    rulers.push_back(ruler);
    if (!is_covered(mesh, ruler, segment, tolerance) && lies_in(mesh, midpoint(ruler.start, ruler.end))) {
      problems.push_back("segment " + std::to_string(s) + " is not covered by edges of its label");
    }
  }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const Point& p = point(mesh, mesh.edges[e][0]);
    const Point& q = point(mesh, mesh.edges[e][1]);
    if (std::none_of(rulers.begin(), rulers.end(), [&p, &q, tolerance](const Ruler& ruler) {
          return ruler.holds(p, tolerance) && ruler.holds(q, tolerance);
        })) {
      problems.push_back("edge " + std::to_string(e) + " lies on no segment");
    }
  }
  return problems;
}

}  // namespace parmesan::oracle
