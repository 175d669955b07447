#include "fem/linear_solver.h"

#include <Eigen/IterativeLinearSolvers>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "fem/gmres.h"
#include "fem/multigrid.h"
#include "fem/norms.h"
#include "fem/reduction.h"
#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

Problem wave_poisson() {
  Problem problem;
  problem.source = [](const Point& p, int) { return -Wave::xx(p) - Wave::yy(p); };
  problem.boundary = dirichlet_everywhere(Wave::value);
  return problem;
}

struct ReducedSystem {
  RowMatrix matrix;
  Eigen::VectorXd load;
};

ReducedSystem reduced(const Mesh& mesh, const Problem& problem) {
  const AssembledSystem system = assemble(mesh, problem);
  const FixedVertices fixed = dirichlet_values(mesh, problem, labelled_sides(mesh));
  return {reduced_matrix(system.matrix, fixed.fixed).matrix,
          reduced_load(system.matrix, system.load, fixed.fixed, fixed.values)};
}

ReducedSystem reduced_poisson(const Mesh& mesh) { return reduced(mesh, wave_poisson()); }

LinearResult solve_linear(const RowMatrix& matrix, const Eigen::VectorXd& b, const MatrixKind& kind,
                          const Eigen::VectorXd& guess, const SolverOptions& options = {}) {
  return LinearSolver(matrix, kind, options).solve(b, guess);
}

}  // namespace

TEST_CASE("a singular system is refused whatever the solver says", "[fem][solver][errors]") {
  RowMatrix matrix(2, 2);
  matrix.insert(0, 0) = 1.0;
  matrix.insert(0, 1) = -1.0;
  matrix.insert(1, 0) = -1.0;
  matrix.insert(1, 1) = 1.0;
  const Eigen::VectorXd b = Eigen::Vector2d(1.0, 1.0);
  for (const MatrixKind kind : {MatrixKind{true, true}, MatrixKind{true, false}, MatrixKind{}}) {
    CHECK_THROWS_AS(solve_linear(matrix, b, kind, Eigen::VectorXd::Zero(2)), SolveError);
  }
}

TEST_CASE("a pure Neumann system that reaches the solvers is refused although they report success",
          "[fem][solver][errors]") {
  // The load sums to 1 and the rows to 0: there is no solution. Round-off makes the last pivot small instead of zero.
  Problem problem;
  problem.source = [](const Point&, int) { return 1.0; };
  const AssembledSystem system = assemble(random_square(20, 0.2, 3), problem);
  const Eigen::VectorXd guess = Eigen::VectorXd::Zero(system.load.size());
  for (const MatrixKind kind : {MatrixKind{true, true}, MatrixKind{}}) {
    CHECK_THROWS_AS(solve_linear(system.matrix, system.load, kind, guess), SolveError);
  }
}

TEST_CASE("a wrong claim of symmetry is found out and corrected", "[fem][solver]") {
  // [4 1; 3 2] x = (1, 3): x = (2 - 3, 12 - 3) / 5 = (-0.2, 1.8). LDLT reads the lower half only.
  RowMatrix matrix(2, 2);
  matrix.insert(0, 0) = 4.0;
  matrix.insert(0, 1) = 1.0;
  matrix.insert(1, 0) = 3.0;
  matrix.insert(1, 1) = 2.0;
  const LinearResult result = solve_linear(matrix, Eigen::Vector2d(1, 3), {true, true}, Eigen::Vector2d::Zero());
  CHECK(result.solver == "LU");
  CHECK(result.x[0] == Approx(-0.2).epsilon(1e-14));
  CHECK(result.x[1] == Approx(1.8).epsilon(1e-14));
}

TEST_CASE("a system without unknowns has an empty solution", "[fem][solver]") {
  CHECK(solve_linear(RowMatrix(0, 0), Eigen::VectorXd(0), {}, Eigen::VectorXd(0)).x.size() == 0);
}

TEST_CASE("every method with every preconditioner finds the solution that is known", "[fem][solver]") {
  // b is made from x, and convection makes the matrix unsymmetric; CG and LDLT get it without.
  const SolverMethod method =
      GENERATE(SolverMethod::Ldlt, SolverMethod::Lu, SolverMethod::Cg, SolverMethod::BiCgStab, SolverMethod::Gmres);
  const Preconditioner preconditioner = GENERATE(Preconditioner::Automatic, Preconditioner::Jacobi,
                                                 Preconditioner::IncompleteLu, Preconditioner::Multigrid);
  const bool symmetric = method == SolverMethod::Cg || method == SolverMethod::Ldlt;
  if (method == SolverMethod::Cg && preconditioner == Preconditioner::IncompleteLu) return;
  Problem problem = wave_poisson();
  if (!symmetric) problem.velocity = [](const Point& p, int) { return Vector{20 * p.y, -10.0}; };
  const Mesh mesh = random_square(40, 0.2, 4);
  const RowMatrix matrix = reduced(mesh, problem).matrix;
  Eigen::VectorXd x(matrix.rows());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = 1.0 + std::sin(0.01 * static_cast<double>(i * i));
  LinearSolver solver(matrix, {symmetric, symmetric, 0.2}, {method, preconditioner, 30});
  CHECK(!solver.approximate(matrix * x));  // nothing has solved yet
  const LinearResult result = solver.solve(matrix * x, Eigen::VectorXd::Zero(x.size()));
  CHECK(result.solver == std::array{"", "LDLT", "LU", "CG", "BiCGSTAB", "GMRES"}[static_cast<std::size_t>(method)]);
  CHECK((result.iterations > 0) == (method != SolverMethod::Ldlt && method != SolverMethod::Lu));
  CHECK((result.x - x).lpNorm<Eigen::Infinity>() < 1e-7);
  // What is prepared does for other loads.
  const Eigen::VectorXd y = x.reverse();
  CHECK((solver.solve(matrix * y, x).x - y).lpNorm<Eigen::Infinity>() < 1e-7);
  CHECK((solver.approximate(matrix * y).value() - y).lpNorm<Eigen::Infinity>() < 1e-2);
  CHECK((solver.solve(matrix * x, y).x - x).lpNorm<Eigen::Infinity>() < 1e-7);
}

TEST_CASE("GMRES that keeps all vectors ends after as many steps as there are different eigenvalues",
          "[fem][solver][gmres]") {
  // Blocks [1 1/2; -1/2 1] and [1]: a normal matrix with the eigenvalues 1 + i/2, 1 - i/2 and 1, whose diagonal is 1.
  RowMatrix matrix(30, 30);
  for (int i = 0; i < 30; ++i) {
    matrix.insert(i, i) = 1.0;
    if (i % 3 == 0) matrix.insert(i, i + 1) = 0.5;
    if (i % 3 == 1) matrix.insert(i, i - 1) = -0.5;
  }
  Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(30, 1.0, 2.0);
  Gmres<Eigen::DiagonalPreconditioner<double>> gmres(30);
  gmres.compute(matrix);
  const Eigen::VectorXd x = gmres.solveWithGuess(b, Eigen::VectorXd::Zero(30));
  CHECK(gmres.info() == Eigen::Success);
  CHECK(gmres.iterations() == 3);
  CHECK((b - matrix * x).norm() < 1e-11 * b.norm());
  CHECK(gmres.solveWithGuess(b, x).isApprox(x));
  CHECK(gmres.iterations() == 0);
}

TEST_CASE("GMRES says so when it stagnates", "[fem][solver][gmres]") {
  // A cyclic shift: every Krylov vector but the last leaves the residual as it is (Nachtigal, Reddy & Trefethen 1992).
  RowMatrix matrix(20, 20);
  for (int i = 0; i < 20; ++i) matrix.insert(i, (i + 19) % 20) = 1.0;
  const Eigen::VectorXd b = Eigen::VectorXd::Unit(20, 0);
  const int restart = GENERATE(5, 20);
  Gmres<Eigen::IdentityPreconditioner> gmres(restart);
  gmres.compute(matrix);
  gmres.solveWithGuess(b, Eigen::VectorXd::Zero(20));
  CHECK((gmres.info() == Eigen::Success) == (restart == 20));
}

TEST_CASE("a wished method that fails is followed by a direct one", "[fem][solver]") {
  // GMRES(1) stalls on an indefinite matrix: where r.A r = 0 no multiple of A r makes the residual r smaller.
  Problem problem = wave_poisson();
  problem.reaction = [](const Point&, int) { return -500.0; };
  const Mesh mesh = random_square(40, 0.2, 5);
  const ReducedSystem system = reduced(mesh, problem);
  const LinearResult result =
      solve_linear(system.matrix, system.load, {true, false}, Eigen::VectorXd::Zero(system.load.size()),
                   {SolverMethod::Gmres, Preconditioner::Jacobi, 1});
  CHECK(result.solver == "LDLT");
  CHECK((system.load - system.matrix * result.x).norm() < 1e-10 * system.load.norm());
}

TEST_CASE("wishes that cannot be met are refused", "[fem][solver][errors]") {
  RowMatrix matrix(1, 1);
  matrix.insert(0, 0) = 1.0;
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(1);
  const auto solve_by = [&](const MatrixKind& kind, const SolverOptions& options) {
    return solve_linear(matrix, b, kind, Eigen::VectorXd::Zero(1), options);
  };
  CHECK_THROWS_AS(solve_by({}, {SolverMethod::Cg}), ProblemError);
  CHECK_THROWS_AS(solve_by({}, {SolverMethod::Ldlt}), ProblemError);
  CHECK_THROWS_AS(solve_by({true, true}, {SolverMethod::Cg, Preconditioner::IncompleteLu}), ProblemError);
  const int restart = GENERATE(0, -1, 1001);
  CHECK_THROWS_AS(solve_by({}, {SolverMethod::Gmres, Preconditioner::Jacobi, restart}), InputError);
}

TEST_CASE("backward_error is that of the definition", "[fem][solver]") {
  // A = diag(2, 4), x = (1, 1), b = (2, 5): r = (0, 1), norms 4, 1, 5: 1 / 9.
  RowMatrix matrix(2, 2);
  matrix.insert(0, 0) = 2.0;
  matrix.insert(1, 1) = 4.0;
  CHECK(backward_error(matrix, Eigen::Vector2d(1, 1), Eigen::Vector2d(2, 5)) == Approx(1.0 / 9.0).epsilon(1e-15));
  CHECK(std::isinf(backward_error(matrix, Eigen::Vector2d(1, NAN), Eigen::Vector2d(2, 5))));
}

TEST_CASE("a multigrid cycle is a symmetric positive definite operator", "[fem][solver][multigrid]") {
  const ReducedSystem system = reduced_poisson(random_square(48, 0.2, 1));
  AggregationMultigrid multigrid;
  multigrid.compute(system.matrix);
  Eigen::VectorXd x(system.load.size());
  Eigen::VectorXd y(system.load.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x[i] = std::sin(3.7 * static_cast<double>(i));
    y[i] = std::cos(1.3 * static_cast<double>(i * i % 1000));
  }
  CHECK(x.dot(multigrid.solve(y)) == Approx(y.dot(multigrid.solve(x))).epsilon(1e-10));
  CHECK(x.dot(multigrid.solve(x)) > 0.0);
}

TEST_CASE("a multigrid cycle reduces the error on round and on stretched meshes", "[fem][solver][multigrid]") {
  const double stretch = GENERATE(1.0, 1e-2, 1e-4);
  const ReducedSystem system = reduced_poisson(mapped(random_square(64, 0.2, 2), [=](const Point& p) {
    return Point{p.x, stretch * p.y};
  }));
  AggregationMultigrid multigrid;
  multigrid.compute(system.matrix);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.load.size());
  for (int cycle = 0; cycle < 20; ++cycle) x += multigrid.solve(system.load - system.matrix * x);
  CHECK((system.load - system.matrix * x).norm() < 1e-3 * system.load.norm());
}

TEST_CASE("multigrid bears unknowns that are coupled to nothing else strongly", "[fem][solver][multigrid]") {
  // Pockets one vertex wide that hardly conduct: their rows sum to 0, so all of the diagonal is weak couplings.
  const Mesh mesh = rectangle_mesh(64, 64);
  Problem problem = wave_poisson();
  problem.diffusion = [](const Point& p, int) {
    const auto in_pocket = [](double x) { return static_cast<int>(64.0 * x) % 8 < 2; };
    const double k = in_pocket(p.x) && in_pocket(p.y) ? 1e-6 : 1.0;
    return Diffusion{k, 0.0, k};
  };
  const ReducedSystem system = reduced(mesh, problem);
  AggregationMultigrid multigrid;
  multigrid.compute(system.matrix);
  REQUIRE(multigrid.info() == Eigen::Success);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.load.size());
  for (int cycle = 0; cycle < 20; ++cycle) x += multigrid.solve(system.load - system.matrix * x);
  CHECK((system.load - system.matrix * x).norm() < 1e-3 * system.load.norm());
}

TEST_CASE("a preconditioner that cannot be made is followed by a direct method", "[fem][solver][errors]") {
  const RowMatrix zeros(3, 3);
  const MatrixKind kind{.symmetric = true, .definite = true};
  for (const auto preconditioner : {Preconditioner::Multigrid, Preconditioner::IncompleteLu, Preconditioner::Jacobi}) {
    for (const auto method : {SolverMethod::Cg, SolverMethod::BiCgStab, SolverMethod::Gmres}) {
      if (method == SolverMethod::Cg && preconditioner == Preconditioner::IncompleteLu) continue;
      SolverOptions options;
      options.method = method;
      options.preconditioner = preconditioner;
      CHECK_THROWS_AS(solve_linear(zeros, Eigen::VectorXd::Ones(3), kind, Eigen::VectorXd::Zero(3), options),
                      SolveError);
    }
  }
}

TEST_CASE("iterative solvers agree with direct ones", "[fem][solver][slow]") {
  // 350^2 cells are beyond the size at which iterations begin; the error of P1 is the oracle.
  const Mesh mesh = bent_square(350);
  Problem problem = wave_poisson();
  double error = 0.0;

  SECTION("CG") {
    const Solution solution = solve(mesh, problem);
    CHECK(solution.report.solver == "CG");
    CHECK(solution.report.iterations < 40);
    error = error_norms(mesh, solution.values, Wave::exact()).l2;
    const Solution again = solve(mesh, problem, solution.values);
    CHECK(again.report.iterations < 5);
  }
  SECTION("CG, pure Neumann") {
    for (auto& [label, condition] : problem.boundary) {
      condition = neumann([](const Point& p, const Vector& n, int) { return dot(n, Wave::gradient(p)); });
    }
    const Solution solution = solve(mesh, problem);
    CHECK(solution.report.solver == "CG");
    CHECK(solution.report.iterations < 60);
    const double shift = Wave::value({0, 0}) - solution.values[0];
    std::vector<double> values = solution.values;
    for (double& v : values) v += shift;
    error = error_norms(mesh, values, Wave::exact()).l2;
  }
  SECTION("BiCGSTAB") {
    const double speed = GENERATE(1.0, 1e3);
    problem.velocity = [speed](const Point&, int) { return Vector{speed, 0.5 * speed}; };
    problem.source = [speed](const Point& p, int) {
      return -Wave::xx(p) - Wave::yy(p) + dot(Vector{speed, 0.5 * speed}, Wave::gradient(p));
    };
    const Solution solution = solve(mesh, problem);
    CHECK(solution.report.solver == "BiCGSTAB");
    error = error_norms(mesh, solution.values, Wave::exact()).l2;
  }
  CHECK(error < 1e-5);
}

TEST_CASE("where conjugate gradients do not converge a direct method takes over", "[fem][solver][slow]") {
  // -laplace u - 2000 u is indefinite; the claim that it is not sends it to CG first.
  const Mesh mesh = rectangle_mesh(330, 330);
  Problem problem = wave_poisson();
  problem.reaction = [](const Point&, int) { return -2000.0; };
  const ReducedSystem system = reduced(mesh, problem);
  REQUIRE(system.load.size() > 100'000);
  const LinearResult result =
      solve_linear(system.matrix, system.load, {true, true}, Eigen::VectorXd::Zero(system.load.size()));
  CHECK(result.solver == "LDLT");
  CHECK((system.load - system.matrix * result.x).norm() < 1e-10 * system.load.norm());
}

}  // namespace parmesan
