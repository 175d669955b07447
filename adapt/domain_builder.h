#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "adapt/shapes.h"
#include "mesher/geometry/domain.h"

namespace parmesan {

/// A piece of a closed path, straight or along a curve.
struct PathPiece {
  Point begin;
  Point end;
  std::string label;
  std::optional<Curve> curve;
};

/// Pieces that each begin where the one before ends, and the first where the last ends.
using Path = std::vector<PathPiece>;

/// Puts a domain together whose labels and regions have names; labels are numbered from 1.
class DomainBuilder {
 public:
  DomainBuilder() = default;
  explicit DomainBuilder(Domain domain);

  /// sides: one name per side (side i starts at point i), or one for all.
  void add_ring(const Ring& ring, const std::vector<std::string>& sides);

  /// A ring with a hole seed inside.
  void add_hole(const Ring& ring, const std::string& side);

  /// The domain with the numbers that labels and regions of these names have here; new ones get numbers. Of the names
  /// it keeps those of regions, for messages.
  Domain renumbered(Domain domain);

  /// Puts a domain with the labels and regions of this one in its place.
  void replace(Domain domain);

  void add_path(const Path& path);

  /// A path with a hole seed inside.
  void add_hole(const Path& path);

  /// is_required: meshes are to mark it so.
  void add_point(const Point& p, bool is_required = false);

  /// right: makes it a crack, name being that of its left side. is_required: it stays one edge.
  void add_segment(const Point& a, const Point& b, const std::string& name,
                   const std::optional<std::string>& right = {}, bool is_required = false);

  /// The same along a curve inside, between its ends.
  void add_curve(const Curve& along, const std::string& name, const std::optional<std::string>& right = {});
  void add_region(const std::string& name, const Point& seed);

  /// Gives a label another name; several labels may come to have the same.
  void rename(int label, const std::string& name) { domain_.label_names[label] = name; }

  /// The labels that segments have, but those of no length, ascending.
  std::vector<int> labels_in_use() const;

  /// Those of the sides of cracks, ascending.
  std::vector<int> crack_labels() const;

  const Domain& domain() const { return domain_; }

 private:
  int label(const std::string& name);
  int region(const std::string& name);
  int curve(const Curve& curve);

  /// The point of the domain at this place, a new one where there is none.
  int point_at(const Point& p);

  Domain domain_;
  std::map<std::pair<double, double>, int> point_of_place_;  // of the first points of the domain
  int num_indexed_ = 0;                                      // how many
  std::map<std::string, int> label_of_name_;
  int last_label_ = 0;
};

}  // namespace parmesan
