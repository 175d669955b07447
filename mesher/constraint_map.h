#pragma once

#include <vector>

#include "mesher/edge_finder.h"
#include "mesher/geometry/domain.h"
#include "mesher/index.h"
#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// What of the domain binds the vertices of a mesh and the edges between them.
class ConstraintMap {
 public:
  /// mesh: its edges labelled with domain segments. Both are referred to, not copied. Cost: O(n).
  ConstraintMap(const Mesh& mesh, const Domain& domain);

  /// Is the vertex a domain point? Is it that, or on a segment?
  bool is_fixed(int vertex) const { return point_[at(vertex)] >= 0; }
  bool is_bound(int vertex) const { return is_fixed(vertex) || segment_[at(vertex)] >= 0; }

  /// Is the edge between the two vertices a part of a segment?
  bool is_constrained(int a, int b) const { return edges_.find(a, b) >= 0; }

  /// Is the edge a required segment?
  bool is_required(int a, int b) const { return required_.find(a, b) >= 0; }

  /// Do the vertices lie on two segments that meet elsewhere, at less than 30 degrees in the metric?
  bool face_across_sharp_corner(int a, int b, const Metric& metric) const;

 private:
  void bind_to_segments();
  void find_isolated_points();
  std::vector<int> segments_at(int vertex) const;
  bool is_at(int vertex, int point) const { return point_[at(vertex)] == point; }

  const Mesh& mesh_;
  const Domain& domain_;
  std::vector<int> point_;                       // domain point of each vertex, -1: none
  std::vector<int> segment_;                     // segment that each vertex lies on, -1: none or a domain point
  std::vector<std::vector<int>> segments_from_;  // of each domain point
  EdgeFinder edges_;                             // that are constrained
  EdgeFinder required_;                          // those of them of required segments
};

}  // namespace parmesan
