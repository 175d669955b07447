#include "fem/anderson.h"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <random>

namespace parmesan {
namespace {

Eigen::VectorXd random_vector(int n, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return uniform(engine); });
}

/// f of x <- x + f(x) = G x + b, G with these eigenvalues, the last one as often as fits.
struct LinearIteration {
  LinearIteration(int n, const std::vector<double>& eigenvalues, unsigned seed) : b(random_vector(n, seed)) {
    Eigen::MatrixXd basis(n, n);
    for (int j = 0; j < n; ++j) basis.col(j) = random_vector(n, seed + 1 + static_cast<unsigned>(j));
    Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(n, eigenvalues.back());
    for (std::size_t j = 0; j < eigenvalues.size(); ++j) diagonal[static_cast<Eigen::Index>(j)] = eigenvalues[j];
    g = basis * diagonal.asDiagonal() * basis.inverse();
  }
  Eigen::VectorXd operator()(const Eigen::VectorXd& x) const { return g * x + b - x; }

  Eigen::MatrixXd g;
  Eigen::VectorXd b;
};

/// |f| after so many steps from zero.
double residual_after(int steps, std::size_t depth, const LinearIteration& f) {
  Anderson acceleration(Eigen::VectorXd::LinSpaced(f.b.size(), 0.5, 2.0), depth);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(f.b.size());
  for (int i = 0; i < steps; ++i) x = acceleration.next(x, f(x));
  return f(x).norm();
}

}  // namespace

TEST_CASE("without memory it is the iteration itself", "[fem][anderson]") {
  const LinearIteration f(8, {0.5}, 3);
  CHECK(residual_after(10, 0, f) == Approx(f.b.norm() / 1024).epsilon(1e-6));
}

TEST_CASE("a few directions that grow do not keep it from the fixed point", "[fem][anderson]") {
  // Four different eigenvalues: a linear problem is solved when the steps span that many directions.
  const LinearIteration f(12, {3.0, -2.0, 1.7, 0.2}, 5);
  CHECK(residual_after(6, 0, f) > f.b.norm());
  CHECK(residual_after(6, 5, f) < 1e-8 * f.b.norm());
}

TEST_CASE("it stays at the fixed point", "[fem][anderson]") {
  const LinearIteration f(6, {0.5, -0.3}, 9);
  const Eigen::VectorXd x = (Eigen::MatrixXd::Identity(6, 6) - f.g).lu().solve(f.b);
  Anderson acceleration(Eigen::VectorXd::Ones(6), 3);
  Eigen::VectorXd y = x;
  for (int i = 0; i < 4; ++i) y = acceleration.next(y, Eigen::VectorXd::Zero(6));
  CHECK(y == x);
}

}  // namespace parmesan
