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
  bool required = false;                // stays whole: one edge of every mesh
  int curve = -1;                       // the one of the domain's that begins at a and ends at b; -1: none
  bool is_straight() const { return curve < 0; }
};

/// The piece of a segment between two points on it, in the segment's direction.
inline Segment piece_of(Segment segment, int a, int b) {
  segment.a = a;
  segment.b = b;
  return segment;
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
  double merge_tolerance = 0.0;  // points nearer than this become one; L
  LabelNames label_names;
  LabelNames region_names;
  int first_number = 0;  // that the user's file gives its points and segments, for messages
};

/// What is done about segments that cross where neither has a point.
enum class Crossings {
  Refuse,
  Split  // both, at the rounded crossing point: the planar subdivision
};

/// A repaired copy and what was repaired, or kept though doubtful, one sentence each.
struct CleanDomain {
  Domain domain;
  std::vector<std::string> repairs;
};

/// Makes a domain fit for triangulation: merges duplicate points, and those nearer than the domain's merge tolerance
/// into the first of them (ends of curves, which cannot move, before others; without a tolerance what is an end but for
/// 16 ulp of the largest coordinate), drops repeated and zero-length
/// segments (the first keeps its label), splits segments at points that lie exactly on them and at
/// overlaps. Keeps the order of points and segments. A crack of one segment, which could not open, gets a point in its
/// middle. Notes free ends but those of cracks, and points that are under 1e-7
/// of the diameter or 16 ulp apart. Messages use the numbers of the domain given, from first_number; points made at
/// crossings are numbered after them.
///
/// Where crossings are split, curves that run together become one, and curved segments are split on both curves.
///
/// Curved segments are split at kinks, in the middle if they begin and end in one point, and at points of the domain
/// that lie on them to 1e-9 of their extent.
///
/// Errors: GeometryError for coordinates that are not finite or over 1e75, indices out of range, a negative tolerance,
/// fewer than three non-collinear points, properly crossing segments (names both and the crossing
/// point) unless they are to be split, segments that curves touch between points, curves that do not begin and end at
/// their segment's points, to 1e-9 of their extent, segments that enclose no area (names an open end), a hole or region
/// seed on a segment. A seed outside of what the segments enclose is not looked for. Cost: O(n log n) expected.
CleanDomain clean(const Domain& domain, Crossings crossings = Crossings::Refuse);

/// The boundary and labelled edges of a mesh as a domain (the corners are the vertices where the
/// boundary turns or its label changes; collinear edges of one label become one segment), with a
/// seed in each hole and in each part of a region other than 0. Collinear is: to 16 ulp of the
/// largest coordinate, since vertices on a slanted segment are rounded. Borders between regions
/// that have no labelled edge become segments of label 0, boundary edges at one place cracks.
///
/// Indices must be in range. Errors: GeometryError for triangles that overlap (see sides_of).
/// Cost: O(n log n) expected.
Domain domain_of(const Mesh& mesh);

}  // namespace parmesan
