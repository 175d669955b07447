#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/geometry/curve.h"
#include "mesher/geometry/point.h"
#include "mesher/mesh.h"

namespace parmesan {

/// One piece of the boundary, of an interior constraint or of a crack, between two domain points: straight, or along a
/// curve.
struct Segment {
  int a = 0;
  int b = 0;
  int label = 0;                        // of a crack: of the side to the left of a -> b
  std::optional<int> label_right = {};  // makes it a crack: the label of the other side
  bool required = false;                // stays whole: one edge of every mesh; for straight ones
  int curve = -1;                       // the one of the domain's that begins at a and ends at b; -1: none
  bool overrides = false;               // where it lies on one that does not, its label is the one that stays
  bool is_straight() const { return curve < 0; }
};

/// The piece of a segment between two points on it, in the segment's direction.
inline Segment piece_of(Segment segment, int a, int b) {
  segment.a = a;
  segment.b = b;
  return segment;
}

/// Do both end at one of the domain's points?
inline bool have_common_end(const Segment& s, const Segment& t) {
  return s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b;
}

/// All triangles that can be reached from the point without crossing a segment get this region.
struct RegionSeed {
  Point point;
  int region = 0;
};

/// How the inside of the domain is told from its outside.
enum class Inside {
  HoleSeeds,  // everything the segments enclose, but for the faces that hold a hole seed (Triangle's rule)
  EvenOdd     // faces that an odd number of segments separates from infinity
};

/// A planar graph of straight and curved segments: what is to be meshed.
///
/// Every point becomes a vertex, every segment a chain of edges of the mesh with its vertices on the segment; a crack
/// two chains, one along each side, that share only its free ends (see cracks.h). Units: L.
struct Domain {
  std::vector<Point> points;
  std::vector<Segment> segments;
  std::vector<Curve> curves;
  std::vector<Point> holes;
  std::vector<RegionSeed> regions;
  std::vector<int> required_points;  // that meshes are to mark as such; all points are kept
  Inside inside = Inside::HoleSeeds;
  double merge_tolerance = 0.0;  // points nearer than this become one, segments bend to them; L
  LabelNames label_names;
  LabelNames region_names;
  int first_number = 0;            // that the user's file gives its points and segments, for messages
  std::vector<std::string> notes;  // what reading it has repaired, one sentence each, for clean() to tell
};

/// What is done about segments that cross where neither has a point.
enum class Crossings {
  Refuse,
  Split  // both, at the rounded crossing point: the planar subdivision
};

}  // namespace parmesan
