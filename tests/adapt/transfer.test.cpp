#include "adapt/transfer.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/errors.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

std::vector<double> nodal(const Mesh& mesh, double (*f)(const Point&)) {
  std::vector<double> values;
  for (const Point& p : mesh.points) values.push_back(f(p));
  return values;
}

}  // namespace

TEST_CASE("transfer reproduces linear functions", "[adapt][transfer]") {
  const Mesh from = support::random_square(9, 0.24, 3);
  const Mesh to = support::random_square(13, 0.24, 8);
  const auto linear = [](const Point& p) { return 3.0 - 2.0 * p.x + 0.5 * p.y; };
  const std::vector<double> values = transfer(from, nodal(from, linear), to);
  for (std::size_t v = 0; v < values.size(); ++v) CHECK(values[v] == Approx(linear(to.points[v])).epsilon(1e-12));
}

TEST_CASE("transfer to the same mesh changes nothing", "[adapt][transfer]") {
  const Mesh mesh = support::random_square(6, 0.2, 1);
  const std::vector<double> values = nodal(mesh, [](const Point& p) { return std::sin(9 * p.x) * p.y; });
  const std::vector<double> same = transfer(mesh, values, mesh);
  for (std::size_t v = 0; v < values.size(); ++v) CHECK(same[v] == Approx(values[v]).margin(1e-12));
}

TEST_CASE("transfer finds its way round a corner and holes of the domain", "[adapt][transfer]") {
  // Two separate squares: walks end at a boundary and must start again.
  const Mesh left = support::rectangle_mesh(5, 5, {0, 0}, {1, 1});
  const Mesh right = support::rectangle_mesh(5, 5, {2, 0}, {3, 1});
  const Mesh from = support::joined(left, right, 10);
  const Mesh to = support::joined(support::rectangle_mesh(3, 4, {2, 0}, {3, 1}), support::rectangle_mesh(4, 3), 10);
  const auto linear = [](const Point& p) { return p.x + 10.0 * p.y; };
  const std::vector<double> values = transfer(from, nodal(from, linear), to);
  for (std::size_t v = 0; v < values.size(); ++v) CHECK(values[v] == Approx(linear(to.points[v])).margin(1e-12));
}

TEST_CASE("transfer takes the nearest place for points outside", "[adapt][transfer]") {
  const Mesh from = support::rectangle_mesh(4, 4);
  Mesh to;
  to.points = {{0.3, -0.5}, {7.0, 9.0}};
  const std::vector<double> values = transfer(from, nodal(from, [](const Point& p) { return p.x + p.y; }), to);
  CHECK(values[0] >= 0.0);
  CHECK(values[0] <= 0.5);
  CHECK(values[1] == Approx(2.0).epsilon(1e-12));
}

TEST_CASE("transfer refuses a wrong number of values", "[adapt][transfer][errors]") {
  const Mesh mesh = support::rectangle_mesh(2, 2);
  CHECK_THROWS_AS(transfer(mesh, std::vector<double>(3), mesh), InputError);
  CHECK_THROWS_AS(transfer(Mesh{}, {}, mesh), InputError);
}
