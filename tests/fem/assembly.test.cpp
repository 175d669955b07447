#include "fem/assembly.h"

#include <omp.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "fem/boundary_conditions.h"
#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

Problem symmetric_problem() {
  Problem problem;
  problem.diffusion = [](const Point& p, int) { return Diffusion{1 + p.x, 0.5 * p.y, 2 + p.y}; };
  problem.reaction = [](const Point& p, int) { return p.x * p.y; };
  return problem;
}

}  // namespace

TEST_CASE("without a velocity the matrix is symmetric to the last bit", "[fem][assembly]") {
  const AssembledSystem system = assemble(random_square(10, 0.24, 7), symmetric_problem());
  CHECK(system.symmetric);
  const RowMatrix transposed = system.matrix.transpose();
  CHECK((system.matrix - transposed).norm() == 0.0);
}

TEST_CASE("diffusion and advection do not see constants, SUPG or not", "[fem][assembly]") {
  Problem problem = symmetric_problem();
  problem.reaction = {};
  problem.velocity = [](const Point& p, int) { return Vector{100 * p.y, -300.0}; };
  const AssembledSystem system = assemble(random_square(10, 0.24, 8), problem);
  CHECK_FALSE(system.symmetric);
  const Eigen::VectorXd rows = system.matrix * Eigen::VectorXd::Ones(system.load.size());
  CHECK(rows.lpNorm<Eigen::Infinity>() < 1e-12 * system.matrix.norm());
}

TEST_CASE("the load and the mass sum to integrals, SUPG or not", "[fem][assembly]") {
  // int (1 + x y^2) over the unit square = 1 + 1/6.
  Problem problem = symmetric_problem();
  problem.source = [](const Point& p, int) { return 1 + p.x * p.y * p.y; };
  if (GENERATE(false, true)) problem.velocity = [](const Point&, int) { return Vector{500, 0}; };
  const AssembledSystem system = assemble(random_square(6, 0.2, 9), problem);
  CHECK(system.load.sum() == Approx(7.0 / 6.0).epsilon(1e-13));
  CHECK(system.mass.sum() == Approx(1.0).epsilon(1e-13));
}

TEST_CASE("the reaction matrix is the integral of products", "[fem][assembly]") {
  // With c = 1 the sum of all entries is the area, and v^T M v = int v^2 for v = x: 1/3.
  Problem problem;
  problem.reaction = [](const Point&, int) { return 1.0; };
  const Mesh mesh = random_square(6, 0.2, 10);
  const RowMatrix with = assemble(mesh, problem).matrix;
  problem.reaction = {};
  const RowMatrix mass = with - assemble(mesh, problem).matrix;
  Eigen::VectorXd x(mesh.num_vertices());
  for (int v = 0; v < mesh.num_vertices(); ++v) x[v] = mesh.points[static_cast<std::size_t>(v)].x;
  CHECK(x.dot(mass * x) == Approx(1.0 / 3.0).epsilon(1e-12));
  CHECK(mass.sum() == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("matrix, load and solution have the same bits for any number of threads", "[fem][assembly][parallel]") {
  const Mesh mesh = random_square(80, 0.2, 11);
  Problem problem = symmetric_problem();
  problem.source = [](const Point& p, int) { return std::atan(1e3 * (p.x - 0.4 * p.y - 0.3)); };
  problem.boundary = dirichlet_everywhere([](const Point& p) { return p.x; });
  if (GENERATE(false, true)) problem.velocity = [](const Point& p, int) { return Vector{1e3 * p.y, 1e3}; };
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const AssembledSystem one = assemble(mesh, problem);
  const std::vector<double> solution = solve(mesh, problem).values;
  for (const int count : {4, 2}) {
    omp_set_num_threads(count);
    const AssembledSystem several = assemble(mesh, problem);
    CHECK((one.matrix - several.matrix).norm() == 0.0);
    CHECK(one.load == several.load);
    CHECK(one.mass == several.mass);
    CHECK(solution == solve(mesh, problem).values);
  }
  omp_set_num_threads(threads);
}

TEST_CASE("of several bad coefficients the one in the first triangle is named, whatever the threads",
          "[fem][assembly]") {
  const Mesh mesh = random_square(80, 0.2, 12);
  Problem problem;
  problem.diffusion = [](const Point& p, int) { return Diffusion{p.x - 0.5, 0.0, 1.0}; };
  const auto message = [&](int count) {
    omp_set_num_threads(count);
    try {
      assemble(mesh, problem);
    } catch (const ProblemError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const int threads = omp_get_max_threads();
  const std::string first = message(1);
  CHECK(first.find("must be positive definite") != std::string::npos);
  CHECK(message(4) == first);
  CHECK(message(2) == first);
  omp_set_num_threads(threads);
}

TEST_CASE("the sign of the reaction and the Robin coefficient decides definiteness", "[fem][assembly]") {
  const Mesh mesh = rectangle_mesh(3, 3);
  Problem problem;
  CHECK(assemble(mesh, problem).definite);
  problem.reaction = [](const Point& p, int) { return p.x - 0.5; };
  CHECK_FALSE(assemble(mesh, problem).definite);
  problem.reaction = {};
  for (const int label : {Bottom, Right, Top, Left}) problem.boundary[label] = neumann({});
  problem.boundary[Top] = robin([](const Point&, const Vector&, int) { return -1.0; }, {});
  AssembledSystem system = assemble(mesh, problem);
  add_flux_conditions(mesh, problem, labelled_sides(mesh), system);
  CHECK_FALSE(system.definite);
}

}  // namespace parmesan
