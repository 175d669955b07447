#include "mesher/arc_heights.h"

#include <algorithm>
#include <cmath>

#include "mesher/geometry/box_tree.h"
#include "mesher/geometry/rounding.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// The curves of a domain, and where they lie. The domain is referred to.
class Curves {
 public:
  explicit Curves(const Domain& domain) : domain_(domain), segments_(domain), rounding_(rounding_of(domain.points)) {
    for (const Segment& segment : domain.segments) {
      if (segment.is_straight()) continue;
      curves_.push_back(&domain.curves[at(segment.curve)]);
      boxes_.emplace_back();
      for (const Point& p : curves_.back()->sample_points()) boxes_.back().add(p);
    }
    tree_ = BoxTree(boxes_.size(), [this](std::size_t i) { return boxes_[i]; });
  }

  /// The height of the arc between two points of one curve that is less than half a circle, where the edge between
  /// them is not on a straight segment.
  double arc_height(const Point& a, const Point& b) const {
    double height = 0.0;
    const Point middle = midpoint(a, b);
    const double reach = 0.5 * norm(b - a);
    const auto is_near = [&](const BoxTree::Box& box) { return box.squared_distance(middle) <= reach * reach; };
    tree_.for_each_in(is_near, [&](std::size_t i) {
      if (height != 0.0 || !is_near(boxes_[i]) || !is_on(*curves_[i], a) || !is_on(*curves_[i], b)) return;
      const Vector to_arc = curves_[i]->at(curves_[i]->nearest(middle)) - middle;
      if (norm(to_arc) < reach) height = cross(to_arc, b - a) / norm(b - a);
    });
    return height != 0.0 && is_on_straight_segment(middle, reach) ? 0.0 : height;
  }

 private:
  static bool is_on(const Curve& curve, const Point& p) {
    constexpr double tolerance = 1e-9;  // of the curve's extent
    return norm(curve.at(curve.nearest(p)) - p) <= tolerance * curve.extent();
  }

  bool is_on_straight_segment(const Point& middle, double reach) const {
    constexpr double tolerance = 1e-9;
    const auto is_straight = [this](int s) { return domain_.segments[at(s)].is_straight(); };
    return segments_.nearest(middle, is_straight, std::max(tolerance * reach, rounding_)).segment >= 0;
  }

  const Domain& domain_;
  SegmentTree segments_;
  double rounding_;  // of coordinates
  std::vector<const Curve*> curves_;
  std::vector<BoxTree::Box> boxes_;
  BoxTree tree_;
};

}  // namespace

std::vector<double> arc_heights(const Mesh& mesh, const Domain& domain) {
  std::vector<double> heights(mesh.edges.size(), 0.0);
  if (!has_curves(domain)) return heights;
  const Curves curves(domain);
  for (std::size_t e = 0; e < heights.size(); ++e)
    heights[e] = curves.arc_height(mesh.points[at(mesh.edges[e][0])], mesh.points[at(mesh.edges[e][1])]);
  return heights;
}

std::vector<EdgeMiddle> middles_of_arcs(const Mesh& mesh, const Domain& domain) {
  const std::vector<double> heights = arc_heights(mesh, domain);
  std::vector<EdgeMiddle> middles;
  for (int e = 0; e < mesh.num_edges(); ++e) {
    if (heights[at(e)] == 0.0) continue;
    const Point& a = mesh.points[at(mesh.edges[at(e)][0])];
    const Point& b = mesh.points[at(mesh.edges[at(e)][1])];
    const Vector to_the_right{b.y - a.y, a.x - b.x};
    middles.push_back({e, midpoint(a, b) + (heights[at(e)] / norm(to_the_right)) * to_the_right});
  }
  return middles;
}

}  // namespace parmesan
