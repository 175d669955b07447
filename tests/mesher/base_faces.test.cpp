#include "mesher/base_faces.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <random>

#include "mesher/delaunay_mesh.h"
#include "mesher/geometry/clean.h"

namespace parmesan {
namespace {

constexpr int kCells = 4;  // in a row

/// Unit cells with the regions 1 and 2, holes (3) and cells without a region (0), by chance; only the sides between
/// different ones are there.
class RandomCells {
 public:
  explicit RandomCells(unsigned seed) : random_(seed) {
    for (auto& row : kinds_)
      for (int& kind : row) kind = std::uniform_int_distribution<int>(0, 3)(random_);
    for (int y = 0; y <= kCells; ++y)
      for (int x = 0; x <= kCells; ++x) domain_.points.push_back({1.0 * x, 1.0 * y});
    for (int y = 0; y <= kCells; ++y) {
      for (int x = 0; x <= kCells; ++x) {
        if (x < kCells && kind(x, y) != kind(x, y - 1)) domain_.segments.push_back({point(x, y), point(x + 1, y), 1});
        if (y < kCells && kind(x, y) != kind(x - 1, y)) domain_.segments.push_back({point(x, y), point(x, y + 1), 1});
      }
    }
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x) {
        const Point middle{x + 0.5, y + 0.5};
        if (kind(x, y) == 3) domain_.holes.push_back(middle);
        if (kind(x, y) == 1 || kind(x, y) == 2) domain_.regions.push_back({middle, kind(x, y)});
        if (kind(x, y) < 3) areas_[kind(x, y)] += 1.0;
      }
    }
    keep_one_seed_each();
  }

  const Domain& domain() const { return domain_; }
  const std::map<int, double>& areas() const { return areas_; }

  /// With segments and points anywhere inside of the square.
  Domain with_others() {
    Domain domain = domain_;
    std::uniform_real_distribution<double> place(0.0, kCells);
    const auto add_point = [&] {
      domain.points.push_back({place(random_), place(random_)});
      return static_cast<int>(domain.points.size()) - 1;
    };
    for (int i = 0; i < 6; ++i) {
      const int a = add_point();
      domain.segments.push_back({a, add_point(), 2});
    }
    for (int i = 0; i < 5; ++i) add_point();
    return domain;
  }

 private:
  static int point(int x, int y) { return x + y * (kCells + 1); }
  bool is_cell(int x, int y) const { return x >= 0 && y >= 0 && x < kCells && y < kCells; }

  /// Outside of the square as in holes, but apart from them.
  int kind(int x, int y) const {
    return is_cell(x, y) ? kinds_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] : 4;
  }

  // Of cells that hang together the first one.
  void keep_one_seed_each() {
    std::map<std::pair<int, int>, bool> done;
    const auto flood = [&](auto&& self, int x, int y, int wanted) -> void {
      if (kind(x, y) != wanted || done[{x, y}]) return;
      done[{x, y}] = true;
      for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)})
        self(self, x + dx, y + dy, wanted);
    };
    const auto is_first = [&](const Point& p) {
      const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
      const bool first = !done[{x, y}];
      flood(flood, x, y, kind(x, y));
      return first;
    };
    std::erase_if(domain_.holes, [&](const Point& p) { return !is_first(p); });
    std::erase_if(domain_.regions, [&](const RegionSeed& seed) { return !is_first(seed.point); });
  }

  std::mt19937 random_;
  std::array<std::array<int, kCells>, kCells> kinds_{};
  Domain domain_;
  std::map<int, double> areas_;
};

std::map<int, double> areas_of_regions(const Mesh& mesh) {
  std::map<int, double> areas;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto corner = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(mesh.triangles[t][i])]; };
    areas[mesh.regions[t]] += 0.5 * cross(corner(1) - corner(0), corner(2) - corner(0));
  }
  return areas;
}

}  // namespace

TEST_CASE("Segments and points anywhere leave the area of each region", "[mesher][base]") {
  const unsigned seed = GENERATE(range(1u, 40u));
  CAPTURE(seed);
  RandomCells cells(seed);
  const Domain domain = with_parts_kept(cells.with_others(), base_of(cells.domain()));
  const std::map<int, double> found = areas_of_regions(delaunay_mesh(clean(domain, Crossings::Split).domain).mesh);
  for (const auto& [region, area] : cells.areas()) {
    CAPTURE(region);
    REQUIRE(found.contains(region));
    CHECK(found.at(region) == Approx(area).epsilon(1e-12));
  }
  CHECK(found.size() == cells.areas().size());
}

TEST_CASE("Seeds stay where nothing was added to what they stand for", "[mesher][base]") {
  RandomCells cells(7);
  Domain domain = cells.domain();
  domain.points.insert(domain.points.end(), {{0.2, 0.2}, {0.8, 0.3}});
  domain.segments.push_back({25, 26, 2});
  const Domain kept = with_parts_kept(domain, base_of(cells.domain()));
  std::size_t num_kept = 0;
  for (const RegionSeed& seed : cells.domain().regions)
    num_kept += static_cast<std::size_t>(
        std::ranges::count_if(kept.regions, [&](const RegionSeed& other) { return other.point == seed.point; }));
  CHECK(num_kept + 1 >= cells.domain().regions.size());
  CHECK(kept.regions.size() == cells.domain().regions.size());
  CHECK(kept.holes.size() == cells.domain().holes.size());
}

}  // namespace parmesan
