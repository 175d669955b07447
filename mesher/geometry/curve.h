#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "mesher/geometry/box_tree.h"
#include "mesher/geometry/point.h"

namespace parmesan {

/// A plane curve, or a part of one, along which a segment of a domain runs. Its parameter t goes from 0 to 1.
///
/// The curve is sampled once, densely enough that it turns by little from one sample to the next; places where it
/// turns at once are its kinks. What turns back within a 60th of the parameter, alone on a straight part, may be
/// missed. Units: L.
class Curve {
 public:
  using Map = std::function<Point(double)>;

  /// The point and its derivative by a parameter that goes from first to last (down, if first > last). breaks:
  /// parameters between which it is smooth, such as knots, in any order. The maps are called on several threads.
  /// Errors: GeometryError where the point is not finite, or when it stays in one place or winds without end.
  Curve(Map point, Map derivative, double first, double last, std::vector<double> breaks = {});

  Point at(double t) const { return point_(parameter(t)); }

  /// Where it is not finite, a difference quotient.
  Vector derivative(double t) const;

  /// The direction of travel, of length 1, also where the derivative vanishes.
  Vector tangent(double t) const;

  /// The same curve from t0 to t1.
  Curve part(double t0, double t1) const;

  /// The parameter of the point of the curve that is nearest to p: to rounding for p on the curve, less and less
  /// accurate as p comes near to a center of curvature. Cost: O(log n) expected in the samples, O(n) near such a
  /// center.
  double nearest(const Point& p) const;

  /// By what angle the curve turns from t0 to t1, turns to the left and to the right both counted as positive.
  double turn(double t0, double t1) const;

  /// Turn per length, the mean over an arc between samples.
  double curvature(double t) const;

  /// Where the direction jumps, ascending, without the ends.
  const std::vector<double>& kinks() const { return kinks_; }

  /// Points along the curve, from end to end, between which it turns by 10 degrees at most.
  std::vector<Point> sample_points() const;

  /// Diagonal of the upright rectangle around the curve.
  double extent() const { return extent_; }

  /// That of the curve that this one is a part of, over any number of parts.
  double whole_extent() const { return whole_extent_; }

  /// The parameters of those points, ascending.
  std::vector<double> sample_parameters() const;

  /// How far edges may be from the curve; nothing limits them by default.
  void limit_chord_error(double distance) { chord_errors_.assign(samples_.size(), distance); }

  /// The same for edges that reach between two samples, if it is less than what was allowed there.
  void lower_chord_error(std::size_t arc, double distance) {
    chord_errors_[arc] = std::min(chord_errors_[arc], distance);
  }

  /// The points that divide the part between two parameters, both left out, into so many of equal steps of t.
  std::vector<Point> points_between(double from, double to, int parts) const;

  /// The largest distance of the arc between two parameters from its chord, at seven points.
  double deviation(double from, double to) const;

  /// How far an edge between two parameters may be.
  double chord_error(double from, double to) const;

  /// Is the arc between two parameters no farther than that from its chord?
  bool is_near_chord(double from, double to) const { return deviation(from, to) <= chord_error(from, to); }

  /// How many edges per parameter the chord error needs near t: an arc that is s away from its chord takes
  /// sqrt(s / limit).
  double least_density(double t) const;

 private:
  struct Sample {
    double t;
    Point point;
    double turned;     // since the beginning
    double deviation;  // of the arc that ends here from its chord
  };

  double parameter(double t) const { return (1.0 - t) * first_ + t * last_; }
  Point checked_point(double t) const;
  Vector inner_difference(double t) const;
  void sample();
  void sample_between(double first, double last);
  std::size_t arc_at(double t) const;
  double distance_to_chord(std::size_t arc, const Point& p) const;
  double nearest_on_arc(std::size_t arc, const Point& p) const;

  Map point_;
  Map derivative_;
  double first_;
  double last_;
  std::vector<double> breaks_;  // ascending
  std::vector<Sample> samples_;
  BoxTree arcs_;  // that end at the samples from the second on, around all that is as near to their chords as they are
  std::vector<double> kinks_;
  double extent_ = 0.0;
  double whole_extent_ = 0.0;
  std::vector<double> chord_errors_;  // of the arc that ends at each sample; empty: no limit
};

}  // namespace parmesan
