#include "fem/boundary_conditions.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/errors.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

}  // namespace

TEST_CASE("labelled_sides have the domain to their left whatever the order in the file", "[fem][boundary]") {
  Mesh mesh = rectangle_mesh(3, 2);
  std::swap(mesh.edges[0][0], mesh.edges[0][1]);
  for (const Side& side : labelled_sides(mesh)) {
    CHECK_FALSE(side.interior);
    const Point middle = midpoint(mesh.points[static_cast<std::size_t>(side.from)],  //
                                  mesh.points[static_cast<std::size_t>(side.to)]);
    CHECK(dot(side.normal, middle - Point{0.5, 0.5}) > 0.3);
  }
}

TEST_CASE("an edge that is the side of no triangle is refused", "[fem][boundary][errors]") {
  Mesh mesh = rectangle_mesh(3, 2);
  mesh.edges.push_back({0, 11});
  mesh.labels.push_back(1);
  CHECK_THROWS_AS(labelled_sides(mesh), GeometryError);
}

TEST_CASE("Neumann data narrower than an edge are integrated well", "[fem][boundary]") {
  // int_0^1 of 1 / (1 + (1000 (y - 0.4))^2) = (atan(600) + atan(400)) / 1000.
  const Mesh mesh = rectangle_mesh(3, 3);
  Problem problem;
  for (const int label : {Bottom, Top, Left}) problem.boundary[label] = dirichlet({});
  problem.boundary[Right] =
      neumann([](const Point& p, const Vector&, int) { return 1.0 / (1.0 + std::pow(1000 * (p.y - 0.4), 2)); });
  AssembledSystem system = assemble(mesh, problem);
  add_flux_conditions(mesh, problem, labelled_sides(mesh), system);
  CHECK(system.load.sum() == Approx((std::atan(600.0) + std::atan(400.0)) / 1000).epsilon(1e-4));
}

TEST_CASE("where Dirichlet labels meet the lower label is taken", "[fem][boundary]") {
  const Mesh mesh = rectangle_mesh(2, 2);
  Problem problem;
  for (const int label : {Bottom, Right, Top, Left}) {
    problem.boundary[label] = dirichlet([label](const Point&, const Vector&, int) { return 10.0 * label; });
  }
  const FixedVertices fixed = dirichlet_values(mesh, problem, labelled_sides(mesh));
  //  30 30 20
  //  40  . 20
  //  10 10 10
  CHECK(fixed.values == std::vector<double>{10, 10, 10, 40, 0, 20, 30, 30, 20});
  CHECK(fixed.fixed == std::vector<char>{1, 1, 1, 1, 0, 1, 1, 1, 1});
}

TEST_CASE("a condition for sides only leaves interior constraints with its label free", "[fem][boundary]") {
  // The line x = 1/2 has a label of its own, or that of a side.
  const int label = GENERATE(9, Top);
  const Mesh mesh = square_with_middle_line(label);
  Problem problem = unit_poisson();
  const std::vector<double> free = solve(rectangle_mesh(4, 4), problem).values;
  for (const BoundaryCondition& condition : {dirichlet({}), neumann({}), robin(constant(1), {})}) {
    if (label == Top && condition.kind != BoundaryKind::Dirichlet) continue;
    problem.boundary[label] = condition;
    problem.boundary[label].on_constraints = false;
    const Solution solution = solve(mesh, problem);
    CHECK(solution.values == free);
    CHECK(solution.fluxes.contains(label) == (label == Top));
  }
}

}  // namespace parmesan
