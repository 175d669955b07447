#include "mesher/io/hanging_vertices.h"

#include <algorithm>
#include <cmath>

#include "mesher/errors.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/rounding.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

Domain domain_of_sides(const std::vector<Point>& points, const std::vector<BoundarySide>& sides) {
  Domain domain;
  domain.points = points;
  for (const BoundarySide& side : sides) domain.segments.push_back({side.from, side.to});
  return domain;
}

class HangingSearch {
 public:
  HangingSearch(const Mesh& mesh, const std::vector<BoundarySide>& sides)
      : mesh_(mesh), sides_(sides), rounding_(rounding_of(mesh.points)), domain_(domain_of_sides(mesh.points, sides)) {}

  void run() const {
    const SegmentTree tree(domain_);
    for (const BoundarySide& side : sides_) {
      check_end(tree, side, side.from, side.to);
      check_end(tree, side, side.to, side.from);
    }
  }

 private:
  const Point& point(int v) const { return mesh_.points[at(v)]; }
  const BoundarySide& side(int s) const { return sides_[at(s)]; }

  bool ends_at(const BoundarySide& side, const Point& p) const { return point(side.from) == p || point(side.to) == p; }

  void check_end(const SegmentTree& tree, const BoundarySide& shorter, int end, int other) const {
    const Point& p = point(end);
    const NearestSegment near = tree.nearest(p, [&](int s) { return !ends_at(side(s), p); });
    if (near.segment < 0 || near.distance > rounding_) return;
    const BoundarySide& longer = side(near.segment);
    if ((longer.edge >= 0 && shorter.edge >= 0) || !lie_on_each_other(longer, shorter, point(other))) return;
    refuse(end, longer);
  }

  // One end of the shorter side lies inside the longer one, so they do if both have one direction and opposite senses.
  bool lie_on_each_other(const BoundarySide& longer, const BoundarySide& shorter, const Point& other) const {
    const Vector along = point(longer.to) - point(longer.from);
    const double off_line = std::abs(cross(along, other - point(longer.from)));
    return off_line <= rounding_ * norm(along) && dot(along, point(shorter.to) - point(shorter.from)) < 0.0;
  }

  [[noreturn]] void refuse(int vertex, const BoundarySide& side) const {
    throw GeometryError("point " + number_text(mesh_, vertex) + " at " + text(point(vertex)) +
                            " hangs: it lies inside the side " + number_text(mesh_, side.from) + "-" +
                            number_text(mesh_, side.to) + " of triangle " + number_text(mesh_, side.triangle) +
                            ", of which it is no corner; divide that triangle there",
                        {vertex, side.triangle});
  }

  const Mesh& mesh_;
  const std::vector<BoundarySide>& sides_;
  double rounding_;
  Domain domain_;
};

}  // namespace

void refuse_hanging_vertices(const Mesh& mesh, const std::vector<BoundarySide>& sides) {
  const auto is_usable = [](const Point& p) {
    return std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate;
  };
  if (std::ranges::all_of(mesh.points, is_usable)) HangingSearch(mesh, sides).run();  // validate() names the others
}

}  // namespace parmesan
