#include "adapt/io/geojson.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "adapt/io/feature_finder.h"
#include "adapt/io/geojson_features.h"
#include "mesher/delaunay_mesh.h"
#include "mesher/disjoint_sets.h"
#include "mesher/errors.h"
#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/geometry/clean.h"
#include "mesher/geometry/domain_of_mesh.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/rounding.h"
#include "mesher/index.h"
#include "mesher/io/text.h"
#include "mesher/mesh_sides.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

void append_ring(const GeoRing& ring, int label, Domain& domain) {
  const int first = static_cast<int>(domain.points.size());
  const int n = static_cast<int>(ring.size());
  domain.points.insert(domain.points.end(), ring.begin(), ring.end());
  for (int i = 0; n > 1 && i < n; ++i) domain.segments.push_back({first + i, first + (i + 1) % n, label});
}

template <class Features, class Visit>
void for_each_ring(Features& features, Visit visit) {
  for (auto& feature : features)
    for (auto& polygon : feature.polygons)
      for (auto& ring : polygon) visit(ring);
}

/// Sides "boundary" and "hole1", ...
Domain domain_of_feature(const GeoFeature& feature) {
  Domain domain;
  domain.inside = Inside::EvenOdd;
  domain.label_names[1] = "boundary";
  if (!feature.name.empty()) domain.region_names[0] = feature.name;
  int last_label = 1;
  for (const GeoPolygon& polygon : feature.polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      if (i > 0) {
        domain.label_names[last_label + 1] = "hole" + std::to_string(last_label);
        ++last_label;
      }
      append_ring(polygon[i], i == 0 ? 1 : last_label, domain);
    }
  }
  return domain;
}

/// The first triangle of the part, bounded by edges, to which each triangle belongs.
std::vector<int> parts_of(const Mesh& mesh) {
  DisjointSets parts(mesh.triangles.size());
  for (const MeshSide& side : sides_of(mesh))
    if (side.edge < 0 && !side.is_boundary()) parts.unite(side.left, side.right);
  std::vector<int> part_of;
  part_of.reserve(mesh.triangles.size());
  for (int t = 0; t < mesh.num_triangles(); ++t) part_of.push_back(parts.find(t));
  return part_of;
}

double area_of(const Mesh& mesh, int triangle) {
  const auto& [a, b, c] = mesh.triangles[at(triangle)];
  return doubled_area(mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)]);
}

Point centroid_of(const Mesh& mesh, int triangle) {
  const auto& [a, b, c] = mesh.triangles[at(triangle)];
  return (1.0 / 3.0) * (mesh.points[at(a)] + mesh.points[at(b)] + mesh.points[at(c)]);
}

/// Gives each part the region in which its largest triangle lies.
/// Errors: GeometryError for holes outside of their polygons, but for what rounding leaves there.
void find_regions(const std::vector<GeoFeature>& features, Mesh& mesh) {
  const std::vector<int> part = parts_of(mesh);
  std::vector<int> largest(part);
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    int& champion = largest[at(part[at(t)])];
    if (area_of(mesh, t) > area_of(mesh, champion)) champion = t;
  }
  const FeatureFinder finder(features);
  const double thinnest = rounding_of(mesh.points) * bounding_diagonal(mesh.points);
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    if (part[at(t)] == t) {
      const Point inside = centroid_of(mesh, largest[at(t)]);
      if (area_of(mesh, largest[at(t)]) > thinnest) finder.refuse_stray_holes_at(inside);
      mesh.regions[at(t)] = finder.region_at(inside);
    }
    mesh.regions[at(t)] = mesh.regions[at(part[at(t)])];
  }
}

/// The region of a triangle, 0 in no feature and where there is no triangle.
int region_of(const Mesh& mesh, int triangle) { return triangle < 0 ? 0 : mesh.regions[at(triangle)]; }

/// Labels for the borders between features, a new one for each pair: "a|b".
class BorderLabels {
 public:
  explicit BorderLabels(LabelNames& names) : names_(names) {}

  int between(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [entry, is_new] = labels_.try_emplace({low, high}, names_.rbegin()->first + 1);
    if (is_new) names_[entry->second] = names_.at(low) + "|" + names_.at(high);
    return entry->second;
  }

 private:
  LabelNames& names_;
  std::map<std::pair<int, int>, int> labels_;
};

/// Drops triangles in no feature, and edges that bound none.
void drop_outside(Mesh& mesh) {
  BorderLabels borders(mesh.label_names);
  Mesh kept;
  for (const MeshSide& side : sides_of(mesh)) {
    const int left = region_of(mesh, side.left), right = region_of(mesh, side.right);
    if (side.edge < 0 || left == right) continue;
    kept.edges.push_back(mesh.edges[at(side.edge)]);
    const bool is_border = left != 0 && right != 0;
    kept.labels.push_back(is_border ? borders.between(left, right) : mesh.labels[at(side.edge)]);
  }
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    if (region_of(mesh, t) == 0) continue;
    kept.triangles.push_back(mesh.triangles[at(t)]);
    kept.regions.push_back(mesh.regions[at(t)]);
  }
  mesh.edges = std::move(kept.edges);
  mesh.labels = std::move(kept.labels);
  mesh.triangles = std::move(kept.triangles);
  mesh.regions = std::move(kept.regions);
}

/// Whether rings of one feature run together: then segments alone do not tell what an odd number of rings enclose.
bool has_shared_sides(const Mesh& mesh) {
  return std::ranges::any_of(sides_of(mesh), [&](const MeshSide& side) {
    return side.edge >= 0 && region_of(mesh, side.left) == region_of(mesh, side.right);
  });
}

/// All rings, each with its number as label.
Domain numbered_rings(const std::vector<GeoFeature>& features) {
  Domain rings;
  int number = 0;
  for_each_ring(features, [&](const GeoRing& ring) { append_ring(ring, number++, rings); });
  return rings;
}

/// The rings with points nearer than the tolerance as one, the first of them, and sides bent to points that are as
/// near, before anything is told by them: what then runs together is a border. Without a tolerance that is so for what
/// rounding of the file's decimals puts apart. Returns what was merged and bent.
std::vector<std::string> merge_rings(std::vector<GeoFeature>& features, double tolerance) {
  Domain rings = numbered_rings(features);
  check_input(rings);
  rings.merge_tolerance = std::max(tolerance, rounding_of(rings.points));
  if (rings.merge_tolerance == 0.0) return {};
  const DomainRepair merged = merge_points(rings);
  auto side = merged.domain.segments.begin();  // in the order of the rings and along them, labelled by their numbers
  int number = 0, num_changed = 0;
  for_each_ring(features, [&](GeoRing& ring) {
    const GeoRing before = std::exchange(ring, {});
    for (; side != merged.domain.segments.end() && side->label == number; ++side) ring.push_back(merged.point(side->a));
    if (ring != before) ++num_changed;
    ++number;
  });
  if (tolerance > 0.0) return merged.repairs;
  if (num_changed == 0) return {};
  return {"put " + std::to_string(num_changed) + (num_changed == 1 ? " ring" : " rings") +
          " to points beside, nearer than " + text(rings.merge_tolerance) + " as rounding leaves them"};
}

/// What the rings enclose, triangulated, each part with the feature that it is in or 0.
Mesh parts_of_features(Domain rings, const std::vector<GeoFeature>& features, Crossings crossings) {
  rings.inside = Inside::HoleSeeds;
  Mesh mesh = delaunay_mesh(crossings == Crossings::Split ? clean(rings, crossings).domain : rings).mesh;
  find_regions(features, mesh);
  return mesh;
}

Domain domain_of_parts(Mesh mesh) {
  drop_outside(mesh);
  if (mesh.triangles.empty()) throw GeometryError("the rings enclose no area");
  return domain_of(mesh);
}

/// Where rings do not run together, the domain that has them as they are given, yet to be merged, by clean().
Domain domain_of_one(const GeoFeature& given, Crossings crossings, double merge_tolerance) {
  std::vector<GeoFeature> features{given};
  std::vector<std::string> merged = merge_rings(features, merge_tolerance);
  const Domain rings = domain_of_feature(features.front());
  Mesh mesh = parts_of_features(rings, features, crossings);
  if (!has_shared_sides(mesh)) {
    Domain domain = domain_of_feature(given);
    domain.merge_tolerance = merge_tolerance;
    return domain;
  }
  Domain domain = domain_of_parts(std::move(mesh));
  domain.regions.clear();
  domain.region_names = rings.region_names;
  domain.notes = std::move(merged);
  return domain;
}

/// All the rings enclose is triangulated; its parts then are in a feature or in none.
Domain domain_of_features(std::vector<GeoFeature> features, Crossings crossings, double merge_tolerance) {
  std::vector<std::string> merged = merge_rings(features, merge_tolerance);
  Domain all;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    all.label_names[number] = features[i].name.empty() ? "feature" + std::to_string(number) : features[i].name;
    for (const GeoPolygon& polygon : features[i].polygons) {
      for (const GeoRing& ring : polygon) append_ring(ring, number, all);
    }
  }
  all.region_names = all.label_names;
  Domain domain = domain_of_parts(parts_of_features(std::move(all), features, crossings));
  domain.notes = std::move(merged);
  return domain;
}

}  // namespace

Domain parse_geojson(const std::string& text, const std::string& name, Crossings crossings, double merge_tolerance) {
  GeoFeatures read = parse_geojson_features(text, name);
  Domain domain = read.features.size() == 1 ? domain_of_one(read.features.front(), crossings, merge_tolerance)
                                            : domain_of_features(std::move(read.features), crossings, merge_tolerance);
  if (!read.left_out.empty()) domain.notes.insert(domain.notes.begin(), "left out what has no area: " + read.left_out);
  return domain;
}

Domain read_geojson(const std::string& path, Crossings crossings, double merge_tolerance) {
  return parse_geojson(read_file(path, kMaxGeoJsonBytes), path, crossings, merge_tolerance);
}

}  // namespace parmesan
