#include "mesher/triangulation/faces.h"

#include <utility>

#include "mesher/triangulation/constraints.h"
#include "mesher/triangulation/delaunay.h"
#include "mesher/triangulation/flood.h"
#include "mesher/triangulation/locate.h"

namespace parmesan {

Faces::Faces(const Domain& domain) : Faces(outline_of(domain), domain.segments.size()) {}

Faces::Faces(const Outline& outline, std::size_t num_segments) {
  triangulation_ = std::move(delaunay(outline.domain.points).triangulation);
  insert_constraints(triangulation_, outline.domain.segments);
  number_faces();
  find_sides(outline.domain.segments, outline.segments, num_segments);
}

void Faces::number_faces() {
  constexpr std::int32_t unknown = -1;
  std::vector<EdgeId> pending = flood_from_hull(triangulation_, unknown);
  while (!pending.empty()) {
    const EdgeId e = pending.back();
    pending.pop_back();
    if (triangulation_.left(e) != unknown) continue;
    const std::vector<EdgeId> beyond = flood(triangulation_, {e}, unknown, count_++);
    pending.insert(pending.end(), beyond.begin(), beyond.end());
  }
}

void Faces::find_sides(const std::vector<Segment>& segments, const std::vector<int>& owners, std::size_t num_owners) {
  const Triangulation& t = triangulation_;
  const auto face = [&t](EdgeId e) { return t.is_inside_left(e) ? t.left(e) : 0; };
  beside_.assign(num_owners, {0, 0});
  for (std::int32_t q = 0; q < t.size(); ++q) {
    const EdgeId e{4 * q};
    if (!t.is_alive(q) || !t.is_constrained(e)) continue;
    const auto s = static_cast<std::size_t>(t.segment(e));
    const bool is_forward = t.org(e) == segments[s].a || t.dest(e) == segments[s].b;
    const EdgeId along = is_forward ? e : sym(e);
    beside_[static_cast<std::size_t>(owners[s])] = {face(along), face(sym(along))};
  }
}

int Faces::at(const Point& p) const {
  const Location where = locate(triangulation_, p, some_inside_edge(triangulation_));
  if (where.hit == Hit::Outside) return 0;
  EdgeId e = where.edge;
  while (!triangulation_.is_inside_left(e)) e = triangulation_.onext(e);
  return triangulation_.left(e);
}

std::vector<FacePoint> Faces::points_inside() const {
  const Triangulation& t = triangulation_;
  std::vector<FacePoint> points(static_cast<std::size_t>(count_));
  for_each_side(t, [&](EdgeId e) {
    const Point& a = t.point(t.org(e));
    const Point& b = t.point(t.dest(e));
    const Point& c = t.point(t.left_apex(e));
    FacePoint& best = points[static_cast<std::size_t>(t.left(e))];
    const double area = doubled_area(a, b, c);
    if (area > best.doubled_area) best = {{(a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0}, area};
  });
  return points;
}

}  // namespace parmesan
