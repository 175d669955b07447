#include "mesher/metric/metric.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "mesher/errors.h"

using namespace parmesan;

namespace {

SymmetricTensor random_tensor(std::mt19937_64& engine, double spread) {
  std::uniform_real_distribution<double> exponent(-spread, spread);
  std::uniform_real_distribution<double> angle(0.0, 7.0);
  const double a = angle(engine);
  return compose({std::pow(10.0, exponent(engine)), std::pow(10.0, exponent(engine)), {std::cos(a), std::sin(a)}});
}

double distance(const SymmetricTensor& a, const SymmetricTensor& b) {
  const double scale = std::abs(b.xx) + std::abs(b.yy) + std::abs(b.xy);
  return (std::abs(a.xx - b.xx) + std::abs(a.xy - b.xy) + std::abs(a.yy - b.yy)) / scale;
}

}  // namespace

TEST_CASE("eigen_decomposition puts a tensor together again", "[mesher][metric]") {
  std::mt19937_64 engine(1);
  for (int i = 0; i < 1000; ++i) {
    const SymmetricTensor t = random_tensor(engine, 4.0);
    const Eigen2 e = eigen_decomposition(t);
    CHECK(distance(compose(e), t) < 1e-14);
    CHECK(e.l1 >= e.l2);
    const Vector residual = t * e.axis - e.l1 * e.axis;
    CHECK(norm(residual) <= 1e-14 * e.l1);
  }
}

TEST_CASE("eigen_decomposition handles zero, rank one and indefinite tensors", "[mesher][metric]") {
  CHECK(eigen_decomposition({0.0, 0.0, 0.0}).l1 == 0.0);
  const Eigen2 rank_one = eigen_decomposition({1.0, 2.0, 4.0});
  CHECK(rank_one.l1 == Approx(5.0).epsilon(1e-15));
  CHECK(rank_one.l2 == Approx(0.0).margin(1e-15));
  const Eigen2 saddle = eigen_decomposition({1.0, 0.0, -3.0});
  CHECK(saddle.l1 == Approx(1.0).epsilon(1e-15));
  CHECK(saddle.l2 == Approx(-3.0).epsilon(1e-15));
  CHECK(std::isfinite(eigen_decomposition({1e-320, 0.0, 0.0}).l2));
}

TEST_CASE("exp is the inverse of log", "[mesher][metric]") {
  std::mt19937_64 engine(2);
  for (int i = 0; i < 1000; ++i) {
    const SymmetricTensor t = random_tensor(engine, 3.0);
    CHECK(distance(exp(log(t)), t) < 1e-9);
  }
  CHECK(distance(exp({1e-9, 0.0, -1e-9}), {1.0 + 1e-9, 0.0, 1.0 - 1e-9}) < 1e-15);
}

TEST_CASE("exp of a diagonal tensor is the exponential of its entries", "[mesher][metric]") {
  const SymmetricTensor e = exp({2.0, 0.0, -5.0});
  CHECK(e.xx == Approx(std::exp(2.0)).epsilon(1e-14));
  CHECK(e.yy == Approx(std::exp(-5.0)).epsilon(1e-11));
}

TEST_CASE("a metric measures its own sizes as 1", "[mesher][metric]") {
  const double angle = GENERATE(0.0, 0.3, 1.5, 4.0);
  const Metric m = Metric::from_sizes(0.02, 3.0, angle);
  const Vector along{0.02 * std::cos(angle), 0.02 * std::sin(angle)};
  const Vector across{-3.0 * std::sin(angle), 3.0 * std::cos(angle)};
  CHECK(m.length(along) == Approx(1.0).epsilon(1e-12));
  CHECK(m.length(across) == Approx(1.0).epsilon(1e-9));
  CHECK(m.density() == Approx(1.0 / 0.06).epsilon(1e-12));
  CHECK(m.isotropised().density() == Approx(m.density()).epsilon(1e-12));
}

TEST_CASE("the intersection of two metrics satisfies both and is no finer than it must be", "[mesher][metric]") {
  std::mt19937_64 engine(3);
  for (int i = 0; i < 200; ++i) {
    const Metric a = Metric::from_tensor(random_tensor(engine, 2.0));
    const Metric b = Metric::from_tensor(random_tensor(engine, 2.0));
    const Metric both = intersect(a, b);
    bool touches = false;
    for (int k = 0; k < 64; ++k) {
      const Vector d{std::cos(0.1 * k), std::sin(0.1 * k)};
      const double asked = std::max(a.length(d), b.length(d));
      CHECK(both.length(d) >= asked * (1.0 - 1e-9));
      touches = touches || both.length(d) <= asked * 1.2;
    }
    CHECK(touches);
  }
}

TEST_CASE("intersecting a metric with itself or a coarser one changes nothing", "[mesher][metric]") {
  const Metric m = Metric::from_sizes(0.1, 2.0, 0.6);
  CHECK(distance(intersect(m, m).tensor(), m.tensor()) < 1e-12);
  CHECK(distance(intersect(m, m.scaled(0.1)).tensor(), m.tensor()) < 1e-12);
  CHECK(distance(intersect(m.scaled(0.1), m).tensor(), m.tensor()) < 1e-12);
}

TEST_CASE("the mean of metrics is the mean of their tensors (5.8, 5.11)", "[mesher][metric]") {
  const Metric a = Metric::isotropic(1.0);
  const Metric b = Metric::isotropic(0.5);
  CHECK(mean(a, b).tensor() == SymmetricTensor{2.5, 0.0, 2.5});
}

TEST_CASE("a metric that is not finite and positive definite is refused", "[mesher][metric][errors]") {
  const double bad =
      GENERATE(0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  CHECK_THROWS_AS(Metric::isotropic(bad), InputError);
  CHECK_THROWS_AS(Metric::from_tensor({bad, 0.0, 1.0}), InputError);
  CHECK_THROWS_AS(Metric::from_tensor({1.0, 2.0, 1.0}), InputError);
}

TEST_CASE("a size without a square is refused by its number", "[mesher][metric][errors]") {
  for (const auto& [size, name] : {std::pair(1e-300, "1e-300"), std::pair(1e300, "1e+300")}) {
    try {
      Metric::isotropic(size);
      FAIL("was taken");
    } catch (const InputError& error) {
      CHECK_THAT(error.what(), Catch::Contains(name));
    }
  }
}
