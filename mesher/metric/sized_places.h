#pragma once

#include <vector>

#include "mesher/geometry/point.h"
#include "mesher/metric/background_mesh.h"

namespace parmesan {

/// Places with the sizes wanted there.
struct SizedPlaces {
  std::vector<Point> points;
  std::vector<double> sizes;

  void add(const Point& p, double size) {
    points.push_back(p);
    sizes.push_back(size);
  }
};

/// Sizes that grow by this factor per unit of metric length at most, between the places, which are triangulated. More
/// are added where what is interpolated would grow less.
BackgroundMesh graded(SizedPlaces places, double growth, double h_max);

}  // namespace parmesan
