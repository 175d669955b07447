#pragma once

#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// The places where a curved segment of a domain meets another, as seen along the curve. On a stretch where the two
/// are within reach of each other they are taken to meet in one place: where one touches the other, if it does. Their
/// common ends are such places, too, but not new. Cost: O(log n) expected for each place that is looked at.
class CurveContacts {
 public:
  /// The domain is referred to, not copied.
  CurveContacts(const Domain& domain, int curved, int other);

  /// Looks for places between two parameters of the curve, from which it turns by some 10 degrees at most. Those where
  /// the segments cross must be apart, but for two.
  void look_between(double from, double to);

  /// Adds a place where they cross.
  void add_crossing(const Point& place) { crossings_.push_back(place); }

  /// Those to be split at, each on both segments to the reach of the curves.
  std::vector<Point> places() const;

  /// How far from each other the segments may be near a point to be taken to meet.
  double reach_near(const Point& p) const;

 private:
  /// What is seen from a point of the curve.
  struct View {
    double height;  // to the left of the other, or of its tangent at an end
    double slope;   // of the height along the curve
    double distance;
    Point place;  // on the other, if that is straight
  };

  View view(double u) const;
  void look_for_crossing(double from, double to);
  bool is_of_one_stretch(const Point& p, const Point& q) const;

  const Domain& domain_;
  Segment curved_;
  Segment other_;
  std::vector<Point> touches_;
  std::vector<Point> crossings_;
};

}  // namespace parmesan
