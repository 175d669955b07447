#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/geometry/repair.h"
#include "mesher/triangulation/faces.h"

namespace parmesan {

/// How many of a domain's points, segments and seeds, the first ones, were a domain before others were added.
struct DomainBase {
  std::size_t points = 0;
  std::size_t segments = 0;
  std::size_t holes = 0;
  std::size_t regions = 0;
};

DomainBase base_of(const Domain& domain);

/// The faces of a domain, all segments split where they cross, and what they were in before others were added to its
/// base: told by the segments between, not by seeds, of which the base has one where there may now be many faces.
class BaseFaces {
 public:
  /// Nothing for a domain that clean() refuses even where crossings are split. Cost: O(n log n) expected.
  static std::optional<BaseFaces> find(const Domain& domain, const DomainBase& base);

  const Faces& faces() const { return faces_; }
  int num_segments() const { return static_cast<int>(sources_.size()); }

  /// The segments of the domain that run along one of the subdivision, ascending.
  const std::vector<int>& sources(int segment) const { return sources_[at(segment)]; }
  bool is_of_base(int segment) const { return sources(segment).front() < num_base_segments_; }

  /// The lowest of the faces that no segment of the base parts from this one.
  int part(int face) const { return parts_[at(face)]; }

  /// By the base's rule and hole seeds.
  bool is_inside(int face) const { return is_inside_[at(face)] != 0; }

  /// Whether the base goes around it, but it is not inside.
  bool is_hole(int face) const { return is_enclosed_[at(face)] != 0 && !is_inside(face); }

 private:
  BaseFaces(Faces faces, const DomainRepair& subdivision, const DomainBase& base);
  void find_parts();
  void find_inside(const Domain& domain, std::size_t num_holes);

  Faces faces_;
  int num_base_segments_;
  std::vector<std::vector<int>> sources_;  // of each segment
  std::vector<int> parts_;                 // of each face, as what follows
  std::vector<char> is_enclosed_;
  std::vector<char> is_inside_;
};

/// The domain with other seeds, so that what was added leaves inside and outside of its base, and the regions of the
/// base, what they were: each face that was parted from others has a seed of its own, and none is where something was
/// added. Of a part of the base that is now several faces, one may have a new region; what was outside of all segments
/// is inside where new ones close it. What clean() refuses stays as it is. Cost: O(n log n) expected.
Domain with_parts_kept(Domain domain, const DomainBase& base);

}  // namespace parmesan
