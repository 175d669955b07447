#include "mesher/half_edges.h"

#include <algorithm>
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

/// Consecutive triangles and the least and greatest of their vertices.
struct Stretch {
  std::size_t first;
  std::size_t last;
  std::size_t least;
  std::size_t greatest;
};

std::vector<Stretch> stretches_of(const Mesh& mesh) {
  const Ranges ranges(mesh.triangles.size());
  std::vector<Stretch> stretches(static_cast<std::size_t>(ranges.count()));
  parallel_for(ranges.count(), [&](int i) {
    Stretch s{ranges.first(i), ranges.last(i), mesh.points.size(), 0};
    for (std::size_t t = s.first; t < s.last; ++t) {
      for (const int corner : mesh.triangles[t]) {
        const auto v = static_cast<std::size_t>(corner);
        s.least = std::min(s.least, v);
        s.greatest = std::max(s.greatest, v);
      }
    }
    stretches[static_cast<std::size_t>(i)] = s;
  });
  return stretches;
}

/// Vertices cut into at most 16 parts, one for each thread that comes to take one: a part looks only at the
/// stretches of triangles that have vertices of its own.
class Parts {
 public:
  explicit Parts(const Mesh& mesh)
      : mesh_(mesh), stretches_(stretches_of(mesh)), length_(std::max(least_length, mesh.points.size() / 16 + 1)) {}

  /// Calls f(low, half-edge) for every side, from several threads: never two at once for the same low.
  template <class F>
  void for_each_side(F f) const {
    const int count = static_cast<int>((mesh_.points.size() + length_ - 1) / length_);
    parallel_for(count, [&](int part) {
      const std::size_t first = static_cast<std::size_t>(part) * length_;
      const std::size_t last = first + length_;
      for (const Stretch& s : stretches_) {
        if (s.greatest < first || s.least >= last) continue;
        const bool is_within = s.least >= first && s.greatest < last;
        for (std::size_t t = s.first; t < s.last; ++t) {
          const auto [a, b, c] = mesh_.triangles[t];
          const int side = static_cast<int>(3 * t);
          const auto visit = [&](int from, int to, int k) {
            const auto low = static_cast<std::size_t>(std::min(from, to));
            if (is_within || (low >= first && low < last)) f(low, HalfEdge{std::max(from, to), side + k});
          };
          visit(b, c, 0);
          visit(c, a, 1);
          visit(a, b, 2);
        }
      }
    });
  }

 private:
  static constexpr std::size_t least_length = 32768;
  const Mesh& mesh_;
  std::vector<Stretch> stretches_;
  std::size_t length_;
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

}  // namespace parmesan
