#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/geometry/outline.h"
#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// A point inside of a face.
struct FacePoint {
  Point place;
  double doubled_area = 0.0;  // of the triangle whose centroid it is
};

/// The faces into which the segments of a clean domain divide the plane, numbered from 0, the unbounded one.
class Faces {
 public:
  /// Errors: GeometryError when all points are collinear. Cost: O(n log n) expected.
  explicit Faces(const Domain& domain);

  /// The same of a domain with so many segments that has this outline.
  Faces(const Outline& outline, std::size_t num_segments);

  int count() const { return count_; }
  int num_segments() const { return static_cast<int>(beside_.size()); }  // of the domain

  /// The faces to the left and to the right of a segment of the domain.
  const std::array<int, 2>& beside(int segment) const { return beside_[static_cast<std::size_t>(segment)]; }

  /// The face that holds a point; of a point on a segment one of those beside it.
  int at(const Point& p) const;

  /// The centroid of the largest triangle of each face; the unbounded one may have none.
  std::vector<FacePoint> points_inside() const;

 private:
  void number_faces();
  void find_sides(const std::vector<Segment>& segments, const std::vector<int>& owners, std::size_t num_owners);

  Triangulation triangulation_;  // of the convex hull; faces carry their number
  int count_ = 1;
  std::vector<std::array<int, 2>> beside_;
};

}  // namespace parmesan
