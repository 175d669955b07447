#include "mesher/io/boundary_edges.h"

#include <catch2/catch.hpp>
#include <utility>

#include "mesher/errors.h"
#include "tests/mesher/io/sample_mesh.h"

using parmesan::cover_boundary;
using parmesan::Mesh;
using parmesan::support::same_arrays;
using parmesan::support::sample_mesh;

TEST_CASE("A covered boundary stays as it is", "[mesher][io]") {
  Mesh mesh = sample_mesh(3);
  cover_boundary(mesh);
  CHECK(same_arrays(mesh, sample_mesh(3)));
}

TEST_CASE("Boundary edges are turned, and missing ones added with label 0", "[mesher][io]") {
  Mesh mesh = sample_mesh(3);
  for (std::size_t i = 0; i < mesh.edges.size(); i += 2) std::swap(mesh.edges[i][0], mesh.edges[i][1]);
  mesh.edges.resize(7);
  mesh.labels.resize(7);
  CHECK_THROWS_AS(parmesan::validate(mesh), parmesan::GeometryError);
  cover_boundary(mesh);
  CHECK_NOTHROW(parmesan::validate(mesh));
  CHECK(mesh.edges.size() == 12);
  CHECK(mesh.labels == std::vector<int>{1, 2, 3, 4, 1, 2, 3, 0, 0, 0, 0, 0});
}

TEST_CASE("The direction of an edge inside is kept", "[mesher][io]") {
  Mesh mesh = sample_mesh(1);
  mesh.edges.push_back({3, 0});
  mesh.labels.push_back(9);
  cover_boundary(mesh);
  CHECK(mesh.edges.back() == std::array{3, 0});
}
