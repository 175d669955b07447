#include "adapt/io/any_geometry.h"

#include <array>
#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesher/cracks.h"
#include "mesher/io/geometry_file.h"
#include "mesher/io/mesh_file.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;

namespace {

constexpr int above = 7;
constexpr int below = 8;

/// The unit square with a crack from (1/4, 1/2) to (3/4, 1/2).
Mesh cracked_square() {
  Mesh mesh = support::rectangle_mesh(4, 4);
  std::vector<std::optional<int>> right_labels(mesh.edges.size());
  for (const int v : {11, 12}) {
    mesh.edges.push_back({v, v + 1});
    mesh.labels.push_back(above);
    right_labels.emplace_back(below);
  }
  return open_cracks(mesh, right_labels).mesh;
}

/// The labels of the crack's upper and lower side.
std::vector<std::array<int, 2>> crack_labels(const Domain& domain) {
  std::vector<std::array<int, 2>> found;
  for (const Segment& s : domain.segments) {
    if (!s.label_right) continue;
    const bool goes_right =
        domain.points[static_cast<std::size_t>(s.a)].x < domain.points[static_cast<std::size_t>(s.b)].x;
    found.push_back(goes_right ? std::array{s.label, *s.label_right} : std::array{*s.label_right, s.label});
  }
  return found;
}

}  // namespace

TEST_CASE("A mesh as geometry has its cracks however the file has their edges", "[adapt][cracks][io]") {
  const support::TemporaryFolder folder;
  Mesh mesh = cracked_square();
  const std::string name = GENERATE("a.mesh", "a.meshb", "a.msh", "a.node");
  CAPTURE(name);
  std::array expected{above, below};
  SECTION("in any direction") {
    const std::vector<int> turned =
        GENERATE(std::vector<int>{}, std::vector{above}, std::vector{below}, std::vector{above, below});
    for (std::size_t e = 0; e < mesh.edges.size(); ++e)
      for (const int label : turned)
        if (mesh.labels[e] == label) std::swap(mesh.edges[e][0], mesh.edges[e][1]);
  }
  SECTION("or not at all") {
    mesh.edges.clear();
    mesh.labels.clear();
    expected = {0, 0};
  }
  write_mesh_file(folder / name, mesh);
  for (const Domain& domain : {read_geometry(folder / name), read_geometry_input(folder / name).domain})
    CHECK(crack_labels(domain) == std::vector{expected});
}
