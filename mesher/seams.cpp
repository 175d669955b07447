#include "mesher/seams.h"

#include <algorithm>

#include "mesher/disjoint_sets.h"
#include "mesher/index.h"
#include "mesher/mesh_sides.h"

namespace parmesan {
std::vector<bool> are_seams(const Mesh& open, std::span<const std::array<std::size_t, 2>> pairs) {
  const auto has_no_label = [&open](const std::array<std::size_t, 2>& pair) {
    return open.labels[pair[0]] == no_label && open.labels[pair[1]] == no_label;
  };
  std::vector<bool> result(pairs.size(), false);
  if (std::ranges::none_of(pairs, has_no_label)) return result;
  DisjointSets parts(open.triangles.size());
  std::vector<int> triangle_at(open.edges.size(), -1);
  for (const MeshSide& side : sides_of(open)) {
    if (side.left >= 0 && side.right >= 0) parts.unite(side.left, side.right);
    if (side.edge >= 0) triangle_at[at(side.edge)] = std::max(side.left, side.right);
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const int one = triangle_at[pairs[i][0]], other = triangle_at[pairs[i][1]];
    result[i] = has_no_label(pairs[i]) && one >= 0 && other >= 0 && parts.find(one) != parts.find(other);
  }
  return result;
}

}  // namespace parmesan
