#include "mesher/mesh_sides.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

#include "mesher/errors.h"

namespace parmesan {

namespace {

/// What a directed edge belongs to, and whether it goes from its lower to its higher vertex.
enum class Use : std::uint64_t { TriangleUp, TriangleDown, EdgeUp, EdgeDown };

/// high, use and index of the owner in one word, so that a sort brings equal edges together.
std::uint64_t packed(int high, Use use, int owner) {
  return static_cast<std::uint64_t>(high) << 33 | static_cast<std::uint64_t>(use) << 31 |
         static_cast<std::uint64_t>(owner);
}
int high_of(std::uint64_t key) { return static_cast<int>(key >> 33); }
Use use_of(std::uint64_t key) { return static_cast<Use>(key >> 31 & 3U); }
int owner_of(std::uint64_t key) { return static_cast<int>(key & 0x7FFFFFFFU); }

/// Calls f(a, b, is_edge, owner) for every directed edge.
template <class F>
void for_each_directed_edge(const Mesh& mesh, F f) {
  int owner = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    f(a, b, false, owner);
    f(b, c, false, owner);
    f(c, a, false, owner++);
  }
  owner = 0;
  for (const auto& [a, b] : mesh.edges) f(a, b, true, owner++);
}

/// Directed edges by their lower vertex v: keys[first[v]] .. keys[first[v + 1] - 1].
struct Buckets {
  std::vector<std::size_t> first;
  std::vector<std::uint64_t> keys;
};

Buckets sorted_into_buckets(const Mesh& mesh) {
  Buckets buckets;
  buckets.first.assign(mesh.points.size() + 2, 0);
  for_each_directed_edge(
      mesh, [&buckets](int a, int b, bool, int) { ++buckets.first[static_cast<std::size_t>(std::min(a, b)) + 2]; });
  for (std::size_t v = 2; v < buckets.first.size(); ++v) buckets.first[v] += buckets.first[v - 1];
  buckets.keys.resize(buckets.first.back());
  for_each_directed_edge(mesh, [&buckets](int a, int b, bool is_edge, int owner) {
    const Use use = is_edge ? (a < b ? Use::EdgeUp : Use::EdgeDown) : (a < b ? Use::TriangleUp : Use::TriangleDown);
    buckets.keys[buckets.first[static_cast<std::size_t>(std::min(a, b)) + 1]++] = packed(std::max(a, b), use, owner);
  });
  return buckets;
}

/// Puts the owner into its slot, which must be free.
void claim(int* slot, int owner, const char* kind, const MeshSide& side) {
  if (*slot >= 0) {
    throw GeometryError(std::string(kind) + "s " + std::to_string(*slot) + " and " + std::to_string(owner) +
                            " both have the side " + std::to_string(side.low) + "-" + std::to_string(side.high) +
                            "; each may occur once in each direction",
                        {*slot, owner});
  }
  *slot = owner;
}

void add_use(MeshSide* side, Use use, int owner) {
  switch (use) {
    case Use::TriangleUp:
      return claim(&side->left, owner, "triangle", *side);
    case Use::TriangleDown:
      return claim(&side->right, owner, "triangle", *side);
    case Use::EdgeUp:
    case Use::EdgeDown:
      side->edge_goes_down = use == Use::EdgeDown;
      return claim(&side->edge, owner, "edge", *side);
  }
}

}  // namespace

std::vector<MeshSide> sides_of(const Mesh& mesh) {
  Buckets buckets = sorted_into_buckets(mesh);
  std::vector<MeshSide> sides;
  sides.reserve(mesh.triangles.size() * 3 / 2 + mesh.edges.size() + 3);
  for (std::size_t low = 0; low < mesh.points.size(); ++low) {
    const std::span bucket(buckets.keys.data() + buckets.first[low], buckets.keys.data() + buckets.first[low + 1]);
    std::sort(bucket.begin(), bucket.end());
    int last_high = -1;
    for (const std::uint64_t key : bucket) {
      if (high_of(key) != last_high) sides.push_back({static_cast<int>(low), last_high = high_of(key)});
      if (last_high == static_cast<int>(low)) {
        throw GeometryError("a side goes from point " + std::to_string(low) + " to itself", {last_high});
      }
      add_use(&sides.back(), use_of(key), owner_of(key));
    }
  }
  return sides;
}

}  // namespace parmesan
