#include "mesher/half_edges.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <numeric>

#include "mesher/parallel.h"

namespace parmesan {
namespace {

bool comes_first(const HalfEdge& a, const HalfEdge& b) { return a.high != b.high ? a.high < b.high : a.side < b.side; }

// By insertion where they are few: a vertex has six in the mean.
void sort_sides(std::span<HalfEdge> sides) {
  constexpr std::size_t few = 16;
  if (sides.size() > few) {
    std::sort(sides.begin(), sides.end(), comes_first);
    return;
  }
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const HalfEdge h = sides[i];
    std::size_t k = i;
    for (; k > 0 && comes_first(h, sides[k - 1]); --k) sides[k] = sides[k - 1];
    sides[k] = h;
  }
}

/// Consecutive triangles and the parts that have vertices of theirs, a bit each.
struct Stretch {
  std::size_t first;
  std::size_t last;
  std::uint32_t parts;
};

// They are short: what is near in the plane may be far away on the curve that vertices are numbered along.
std::vector<Stretch> stretches_of(const Mesh& mesh, int part_bits) {
  constexpr std::size_t length = 1024;
  const std::size_t size = mesh.triangles.size();
  std::vector<Stretch> stretches((size + length - 1) / length);
  const Ranges ranges(stretches.size());
  parallel_for(ranges.count(), [&](int range) {
    for (std::size_t i = ranges.first(range); i < ranges.last(range); ++i) {
      Stretch s{i * length, std::min((i + 1) * length, size), 0};
      for (std::size_t t = s.first; t < s.last; ++t)
        for (const int corner : mesh.triangles[t]) s.parts |= 1U << (corner >> part_bits);
      stretches[i] = s;
    }
  });
  return stretches;
}

/// Vertices cut into at most 32 parts, one for each thread that comes to take one: a part looks only at the
/// stretches of triangles that have vertices of its own.
class Parts {
 public:
  explicit Parts(const Mesh& mesh)
      : mesh_(mesh),
        bits_(std::max(least_bits, static_cast<int>(std::bit_width(mesh.points.size() / 32)))),
        stretches_(stretches_of(mesh, bits_)) {}

  /// Calls f(low, half-edge) for every side, from several threads: never two at once for the same low.
  template <class F>
  void for_each_side(F f) const {
    const int count = static_cast<int>(mesh_.points.size() >> bits_) + 1;
    parallel_for(count, [&](int part) {
      const std::uint32_t own = 1U << part;
      for (const Stretch& s : stretches_) {
        if ((s.parts & own) == 0) continue;
        const bool is_within = s.parts == own;
        for (std::size_t t = s.first; t < s.last; ++t) {
          const auto [a, b, c] = mesh_.triangles[t];
          const int side = static_cast<int>(3 * t);
          const auto visit = [&](int from, int to, int k) {
            const auto low = static_cast<std::size_t>(std::min(from, to));
            if (is_within || static_cast<int>(low >> bits_) == part) f(low, HalfEdge{std::max(from, to), side + k});
          };
          visit(b, c, 0);
          visit(c, a, 1);
          visit(a, b, 2);
        }
      }
    });
  }

 private:
  static constexpr int least_bits = 15;
  const Mesh& mesh_;
  int bits_;  // 2^bits vertices are a part
  std::vector<Stretch> stretches_;
};

}  // namespace

HalfEdges::HalfEdges(const Mesh& mesh)
    : start_(mesh.points.size() + 1, 0), all_(std::make_unique_for_overwrite<HalfEdge[]>(3 * mesh.triangles.size())) {
  const Parts parts(mesh);
  parts.for_each_side([&](std::size_t low, const HalfEdge&) { ++start_[low + 1]; });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<std::uint32_t> end(start_.begin(), start_.end() - 1);
  parts.for_each_side([&](std::size_t low, const HalfEdge& h) { all_[end[low]++] = h; });
  const Ranges ranges(mesh.points.size());
  parallel_for(ranges.count(), [&](int range) {
    for (std::size_t v = ranges.first(range); v < ranges.last(range); ++v)
      sort_sides({all_.get() + start_[v], all_.get() + start_[v + 1]});
  });
}

int num_boundary_sides(const Mesh& mesh) {
  const HalfEdges half_edges(mesh);
  int num_shared = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const std::span<const HalfEdge> sides = half_edges.at(v);
    for (std::size_t i = 1; i < sides.size(); ++i) num_shared += sides[i - 1].high == sides[i].high ? 1 : 0;
  }
  return 3 * mesh.num_triangles() - 2 * num_shared;
}

}  // namespace parmesan
