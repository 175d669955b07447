#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/index.h"
#include "mesher/triangulation/faces.h"

namespace parmesan {

/// How many of the segments that count lie between each face and the unbounded one, at least. Cost: O(n).
std::vector<int> layers_of(const Faces& faces, const std::function<bool(int)>& counts);

inline bool is_inside_layer(int layer, Inside rule) { return rule == Inside::EvenOdd ? layer % 2 == 1 : layer > 0; }

/// Which faces are inside of a domain, by its rule and its hole seeds.
std::vector<char> faces_inside(const Domain& domain, const Faces& faces);

/// The segments beside each face. Cost: O(n).
std::vector<std::vector<int>> segments_around(const Faces& faces);

/// A walk from the unbounded face to all others, the way it came, and back: cross(s) where it goes across segment s, to
/// either side, and enter(f) where it comes into face f first. Cost: O(n).
template <class Cross, class Enter>
void walk_faces(const Faces& faces, Cross cross, Enter enter) {
  struct Step {
    int face;
    int across;  // the segment on the way here
    std::size_t next = 0;
  };
  const std::vector<std::vector<int>> around = segments_around(faces);
  std::vector<char> is_known(around.size(), 0);
  std::vector<Step> way;
  const auto go = [&](int face, int across) {
    is_known[at(face)] = 1;
    enter(face);
    way.push_back({face, across});
  };
  go(0, -1);
  while (!way.empty()) {
    Step& here = way.back();
    const std::vector<int>& segments = around[at(here.face)];
    if (here.next == segments.size()) {
      if (here.across >= 0) cross(here.across);
      way.pop_back();
      continue;
    }
    const int s = segments[here.next++];
    const auto& [left, right] = faces.beside(s);
    const int to = left == here.face ? right : left;
    if (is_known[at(to)] != 0) continue;
    cross(s);
    go(to, s);
  }
}

}  // namespace parmesan
