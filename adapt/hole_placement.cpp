#include "adapt/hole_placement.h"

#include <optional>
#include <set>
#include <utility>

#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/geometry/rounding.h"
#include "mesher/index.h"
#include "mesher/triangulation/face_walks.h"

namespace parmesan {
namespace {

/// Which holes' rings go around each face.
class HoleFaces {
 public:
  HoleFaces(const BaseFaces& found, const std::vector<PlacedHole>& holes, const Domain& domain)
      : found_(found), holes_(holes), points_(found.faces().points_inside()) {
    thinnest_ = rounding_of(domain.points) * bounding_diagonal(domain.points);
    holes_around_.resize(points_.size());
    find_owners(domain);
    walk();
  }

  std::vector<HoleFault> faults() const;

  /// For each hole the seeds that it needs: its own, which clean() refuses where a merge tolerance closes the hole, or
  /// one in each of its faces where others run through it.
  std::vector<Point> seeds(const std::vector<Point>& given) const;

 private:
  void find_owners(const Domain& domain);
  void walk();

  /// What rounding may leave between a hole and a side that it touches.
  bool is_thin(int face) const { return points_[at(face)].doubled_area <= thinnest_; }

  const BaseFaces& found_;
  const std::vector<PlacedHole>& holes_;
  std::vector<FacePoint> points_;
  std::vector<int> owners_;                  // of each segment of the domain, its hole; -1: of the base
  std::vector<std::set<int>> holes_around_;  // of each face
  double thinnest_ = 0.0;
};

void HoleFaces::find_owners(const Domain& domain) {
  owners_.assign(domain.segments.size(), -1);
  for (std::size_t h = 0; h < holes_.size(); ++h)
    for (std::size_t s = holes_[h].first_segment; s < holes_[h].last_segment; ++s) owners_[s] = static_cast<int>(h);
}

void HoleFaces::walk() {
  std::set<int> around;  // where the walk is
  const auto cross = [&](int segment) {
    for (const int source : found_.sources(segment)) {
      const int hole = owners_[at(source)];
      if (hole >= 0 && !around.insert(hole).second) around.erase(hole);
    }
  };
  walk_faces(found_.faces(), cross, [&](int face) { holes_around_[at(face)] = around; });
}

std::vector<HoleFault> HoleFaces::faults() const {
  std::set<int> misplaced;
  std::set<std::pair<int, int>> overlapping;  // the first, the second
  for (int face = 0; face < found_.faces().count(); ++face) {
    const std::set<int>& around = holes_around_[at(face)];
    if (around.empty() || is_thin(face)) continue;
    if (!found_.is_inside(face)) misplaced.insert(around.begin(), around.end());
    for (const int hole : around)
      if (hole != *around.begin()) overlapping.emplace(*around.begin(), hole);
  }
  std::vector<HoleFault> faults;
  for (const int hole : misplaced) faults.push_back({at(hole), "does not lie inside of the domain"});
  for (const auto& [first, second] : overlapping)
    faults.push_back({at(second), "lies in or around the hole " + holes_[at(first)].pointer +
                                      ", or across it; holes lie apart, and an island is a shape of a \"union\""});
  return faults;
}

std::vector<Point> HoleFaces::seeds(const std::vector<Point>& given) const {
  std::vector<std::vector<int>> faces(holes_.size());
  std::vector<char> is_divided(holes_.size(), 0);
  for (int face = 0; face < found_.faces().count(); ++face)
    for (const int hole : holes_around_[at(face)]) faces[at(hole)].push_back(face);
  for (int s = 0; s < found_.num_segments(); ++s) {
    const auto& [left, right] = found_.faces().beside(s);
    for (const int hole : holes_around_[at(left)])
      if (holes_around_[at(right)].contains(hole)) is_divided[at(hole)] = 1;
  }
  std::vector<Point> seeds;
  for (std::size_t h = 0; h < holes_.size(); ++h) {
    if (faces[h].size() < 2 && is_divided[h] == 0) {
      seeds.push_back(given[h]);
    } else {
      for (const int face : faces[h]) seeds.push_back(points_[at(face)].place);
    }
  }
  return seeds;
}

}  // namespace

HolePlacement place_holes(Domain domain, const std::vector<PlacedHole>& holes, const DomainBase& base) {
  const std::optional<BaseFaces> found = BaseFaces::find(domain, base);
  if (!found) return {std::move(domain), {}};
  const HoleFaces faces(*found, holes, domain);
  if (std::vector<HoleFault> faults = faces.faults(); !faults.empty()) return {std::move(domain), std::move(faults)};
  const auto first = domain.holes.begin() + static_cast<std::ptrdiff_t>(base.holes);
  const std::vector<Point> seeds = faces.seeds({first, domain.holes.end()});
  domain.holes.erase(first, domain.holes.end());
  domain.holes.insert(domain.holes.end(), seeds.begin(), seeds.end());
  const bool has_seeds = domain.inside == Inside::HoleSeeds && base.regions == 0;
  return {has_seeds ? std::move(domain) : with_parts_kept(std::move(domain), base), {}};
}

}  // namespace parmesan
