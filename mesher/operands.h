#pragma once

#include <span>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/triangulation/faces.h"

namespace parmesan {

/// What of several domains a set operation works on, in one graph whose segments may cross: their boundaries, and the
/// segments, points and region seeds inside of them.
struct Operands {
  Domain all;
  std::vector<int> owners;      // of each segment, the domain that it is of
  std::vector<char> is_border;  // of each segment: the domain lies on one side of it only
  int count = 0;
};

/// Points within 16 ulp of the largest coordinate of an earlier one become that one, those as near to a straight
/// segment are put on it: what was rounded apart comes together again. Other coordinates stay as they are.
/// Errors: GeometryError as clean, in the numbering of the domain; for a hole seed outside of it.
/// Cost: O(n log n) expected.
Operands gather(std::span<const Domain> domains);

/// The same with chords in place of the curves of some segments, off by 1e-4 of a curve's extent at most.
Operands with_chords(const Operands& operands, std::span<const char> is_replaced);

/// Which faces are inside of a domain, by its rule and its hole seeds.
std::vector<char> faces_inside(const Domain& domain, const Faces& faces);

/// Which faces are reached from the unbounded one across an odd number of segments. toggles(s): whether segment s
/// counts.
template <class Toggles>
std::vector<char> odd_faces(int num_segments, const Faces& faces, Toggles toggles) {
  std::vector<std::vector<int>> around(static_cast<std::size_t>(faces.count()));  // segments of each face
  for (int s = 0; s < num_segments; ++s)
    for (const int face : faces.beside(s)) around[static_cast<std::size_t>(face)].push_back(s);
  std::vector<char> is_odd(around.size(), 0);
  std::vector<char> is_known(around.size(), 0);
  std::vector<int> open{0};
  is_known[0] = 1;
  while (!open.empty()) {
    const int from = open.back();
    open.pop_back();
    for (const int s : around[static_cast<std::size_t>(from)]) {
      const auto& [left, right] = faces.beside(s);
      const auto to = static_cast<std::size_t>(left == from ? right : left);
      if (is_known[to] != 0) continue;
      is_known[to] = 1;
      is_odd[to] = static_cast<char>((is_odd[static_cast<std::size_t>(from)] != 0) != toggles(s));
      open.push_back(static_cast<int>(to));
    }
  }
  return is_odd;
}

}  // namespace parmesan
