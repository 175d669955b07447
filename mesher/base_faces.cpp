#include "mesher/base_faces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "mesher/disjoint_sets.h"
#include "mesher/errors.h"
#include "mesher/geometry/isolated_points.h"
#include "mesher/geometry/outline.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/triangulation/face_walks.h"

namespace parmesan {
namespace {

/// Chords of curves that are on the same side of the seeds as the curves; where a seed is on a curve without regard to
/// seeds.
std::optional<Outline> outline_around_seeds(const Domain& subdivision, const Domain& seeds) {
  Domain domain = subdivision;
  domain.holes = seeds.holes;
  domain.regions = seeds.regions;
  OutlineResult around = find_outline(domain);
  if (around.conflict) around = find_outline(subdivision);
  if (around.conflict) return std::nullopt;
  return std::move(around.outline);
}

struct Subdivision {
  DomainRepair graph;
  Outline outline;
};

/// Of a domain with curves that nothing crosses: to see that takes much less time than to look for the crossings.
std::optional<Subdivision> uncrossed(const Domain& bare, const Domain& seeds) {
  if (!has_curves(bare)) return std::nullopt;
  DomainRepair graph = split_at_inner_vertices(first_stages(bare));
  try {
    refuse_straight_crossings(graph);
  } catch (const GeometryError&) {
    return std::nullopt;
  }
  std::optional<Outline> outline = outline_around_seeds(graph.domain, seeds);
  if (!outline) return std::nullopt;
  return Subdivision{std::move(graph), std::move(*outline)};
}

/// Nothing where curves touch.
std::optional<Subdivision> subdivision_of(const Domain& domain) {
  Domain bare = domain;
  bare.holes.clear();
  bare.regions.clear();
  if (std::optional<Subdivision> found = uncrossed(bare, domain)) return found;
  DomainRepair graph = subdivide(bare);
  std::optional<Outline> outline = outline_around_seeds(graph.domain, domain);
  if (!outline) return std::nullopt;
  return Subdivision{std::move(graph), std::move(*outline)};
}

/// Errors: GeometryError for seeds of what a merge tolerance closes, which would be found in what is beside it.
void refuse_closed_parts(Domain domain, const DomainBase& base) {
  domain.points.resize(base.points);
  domain.segments.resize(base.segments);
  domain.holes.resize(base.holes);
  domain.regions.resize(base.regions);
  std::erase_if(domain.required_points, [&base](int v) { return at(v) >= base.points; });
  merge_points(domain);
}

/// New seeds for a domain some of whose parts were changed.
class SeedSpread {
 public:
  SeedSpread(const BaseFaces& found, const Domain& domain, const DomainBase& base)
      : found_(found), domain_(domain), base_(base), points_(found.faces().points_inside()) {
    find_new_holes();
    find_changed_parts();
  }

  std::vector<Point> holes() const;
  std::vector<RegionSeed> regions() const;

 private:
  int face_at(const Point& p) const { return found_.faces().at(p); }
  bool is_changed(int face) const { return is_changed_[at(found_.part(face))] != 0; }
  void find_new_holes();
  void find_changed_parts();

  const BaseFaces& found_;
  const Domain& domain_;
  const DomainBase& base_;
  std::vector<FacePoint> points_;
  std::vector<char> is_changed_;              // of each part
  std::vector<char> is_new_hole_;             // of each face
  std::vector<std::vector<int>> faces_left_;  // of each part, those that are no new holes
};

void SeedSpread::find_new_holes() {
  is_new_hole_.assign(points_.size(), 0);
  for (std::size_t i = base_.holes; i < domain_.holes.size(); ++i) is_new_hole_[at(face_at(domain_.holes[i]))] = 1;
}

void SeedSpread::find_changed_parts() {
  is_changed_.assign(points_.size(), 0);
  faces_left_.resize(points_.size());
  for (int face = 0; face < found_.faces().count(); ++face) {
    if (is_new_hole_[at(face)] != 0) {
      is_changed_[at(found_.part(face))] = 1;
    } else {
      faces_left_[at(found_.part(face))].push_back(face);
    }
  }
  for (int s = 0; s < found_.num_segments(); ++s)
    if (!found_.is_of_base(s)) is_changed_[at(found_.part(found_.faces().beside(s)[0]))] = 1;
  for (const int p : isolated_points(domain_))
    if (at(p) >= base_.points) is_changed_[at(found_.part(face_at(domain_.points[at(p)])))] = 1;
}

std::vector<Point> SeedSpread::holes() const {
  std::vector<Point> holes;
  for (std::size_t i = 0; i < domain_.holes.size(); ++i)
    if (i >= base_.holes || !is_changed(face_at(domain_.holes[i]))) holes.push_back(domain_.holes[i]);
  const bool has_seeds = domain_.inside == Inside::HoleSeeds;
  for (int face = 1; face < found_.faces().count(); ++face) {
    const bool has_seed = is_new_hole_[at(face)] != 0 || (has_seeds && !is_changed(face));
    if (found_.is_hole(face) && !has_seed) holes.push_back(points_[at(face)].place);
  }
  return holes;
}

std::vector<RegionSeed> SeedSpread::regions() const {
  const auto first_new = domain_.regions.begin() + static_cast<std::ptrdiff_t>(base_.regions);
  std::vector<char> has_new_region(points_.size(), 0);
  for (auto seed = first_new; seed != domain_.regions.end(); ++seed) has_new_region[at(face_at(seed->point))] = 1;
  std::vector<RegionSeed> regions;
  std::map<int, int> region_of_part;
  for (auto seed = domain_.regions.begin(); seed != first_new; ++seed) {
    const int face = face_at(seed->point);
    const int part = found_.part(face);
    const auto [known, is_new] = region_of_part.emplace(part, seed->region);
    if (!is_changed(face) || !found_.is_inside(face) || known->second != seed->region) {
      regions.push_back(*seed);
    } else if (is_new) {
      for (const int left : faces_left_[at(part)])
        if (has_new_region[at(left)] == 0 || faces_left_[at(part)].size() == 1)
          regions.push_back({points_[at(left)].place, seed->region});
    }
  }
  regions.insert(regions.end(), first_new, domain_.regions.end());
  return regions;
}

}  // namespace

DomainBase base_of(const Domain& domain) {
  return {domain.points.size(), domain.segments.size(), domain.holes.size(), domain.regions.size()};
}

std::optional<BaseFaces> BaseFaces::find(const Domain& domain, const DomainBase& base) {
  try {
    check_input(domain);
    refuse_closed_parts(domain, base);
    std::optional<Subdivision> found = subdivision_of(domain);
    if (!found) return std::nullopt;
    DomainRepair& graph = found->graph;
    graph.domain.holes = domain.holes;
    return BaseFaces(Faces(found->outline, graph.domain.segments.size()), graph, base);
  } catch (const InputError&) {
    return std::nullopt;  // clean() says it in the order of its checks
  }
}

BaseFaces::BaseFaces(Faces faces, const DomainRepair& subdivision, const DomainBase& base)
    : faces_(std::move(faces)), num_base_segments_(static_cast<int>(base.segments)) {
  for (const SegmentSource& source : subdivision.segment_sources) sources_.push_back(source.all());
  find_parts();
  find_inside(subdivision.domain, base.holes);
}

void BaseFaces::find_parts() {
  DisjointSets parts(at(faces_.count()));
  for (int s = 0; s < num_segments(); ++s)
    if (!is_of_base(s)) parts.unite(faces_.beside(s)[0], faces_.beside(s)[1]);
  for (int face = 0; face < faces_.count(); ++face) parts_.push_back(parts.find(face));
}

void BaseFaces::find_inside(const Domain& domain, std::size_t num_holes) {
  const std::vector<int> layers = layers_of(faces_, [this](int s) { return is_of_base(s); });
  std::vector<char> is_cut(layers.size(), 0);  // of each part
  for (std::size_t i = 0; i < num_holes; ++i) is_cut[at(part(faces_.at(domain.holes[i])))] = 1;
  for (int face = 0; face < faces_.count(); ++face) {
    const int layer = layers[at(face)];
    is_enclosed_.push_back(static_cast<char>(layer > 0));
    is_inside_.push_back(static_cast<char>(is_inside_layer(layer, domain.inside) && is_cut[at(part(face))] == 0));
  }
}

Domain with_parts_kept(Domain domain, const DomainBase& base) {
  const std::optional<BaseFaces> found = BaseFaces::find(domain, base);
  if (!found) return domain;
  const SeedSpread spread(*found, domain, base);
  std::vector<Point> holes = spread.holes();
  domain.regions = spread.regions();
  domain.holes = std::move(holes);
  domain.inside = Inside::HoleSeeds;
  return domain;
}

}  // namespace parmesan
