#include "mesher/particles/thesis_potential.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

using namespace parmesan;

namespace {

struct Known {
  PotentialKind kind;
  std::function<double(double)> value;  // phi, by hand
};

}  // namespace

TEST_CASE("phi' is the derivative of the potential that the thesis defines", "[mesher][particles][thesis]") {
  const Known known = GENERATE(
      Known{PotentialKind::Gaussian, [](double l) { return -std::exp(-2 * l * l); }},
      Known{PotentialKind::GaussianDerivative, [](double l) { return l * std::exp(-l * l / 2); }},
      Known{PotentialKind::LennardJones, [](double l) { return 6 * std::pow(l, -12) * (2 * std::pow(l, 6) - 1); }},
      Known{PotentialKind::Shimada,
            [](double l) { return 5 * std::pow(l, 4) / 16 - 19 * std::pow(l, 3) / 24 + 9 * l / 8; }},
      Known{PotentialKind::Laplacian, [](double l) { return -l * l / 4; }},
      Known{PotentialKind::LengthError, [](double l) { return -(l - 1) * (l - 1) / 2; }},
      Known{PotentialKind::RatioError, [](double l) { return -std::log(l) * std::log(l) / 2; }});
  const Potential potential(known.kind, 1.0);
  for (const double l : {0.5, 0.8, 1.0, 1.2, 1.45}) {
    const double h = 1e-5;
    const double slope = (known.value(l + h) - known.value(l - h)) / (2 * h);
    CHECK(potential.derivative(l) == Approx(slope).epsilon(1e-5).margin(1e-6));
  }
}

TEST_CASE("potentials that attract and repel do so on either side of 1", "[mesher][particles][thesis]") {
  const PotentialKind kind =
      GENERATE(PotentialKind::GaussianDerivative, PotentialKind::LennardJones, PotentialKind::Shimada,
               PotentialKind::LennardJonesApproximation, PotentialKind::LengthError, PotentialKind::RatioError);
  const Potential potential(kind, 1.0);
  CHECK(potential.derivative(0.9) > 0.0);
  CHECK(potential.derivative(1.0) == Approx(0.0).margin(1e-12));
  CHECK(potential.derivative(1.1) < 0.0);
}

TEST_CASE("Shimada's force ends at 1.5, continuously", "[mesher][particles][thesis]") {
  const Potential potential(PotentialKind::Shimada, 1.0);
  CHECK(potential.derivative(1.5 - 1e-9) == Approx(0.0).margin(1e-8));
  CHECK(potential.derivative(1.51) == 0.0);
  CHECK(potential.derivative(2.0) == 0.0);
}

TEST_CASE("decay weakens the far force of 3.20 and keeps its equilibrium", "[mesher][particles][thesis]") {
  CHECK(std::abs(Potential(PotentialKind::LennardJonesApproximation, 2.0).derivative(1.3)) <
        std::abs(Potential(PotentialKind::LennardJonesApproximation, 1.0).derivative(1.3)));
}

TEST_CASE("Newton's step on the hexagonal lattice", "[mesher][particles][thesis]") {
  const auto step = [](PotentialKind kind) { return newton_step(Potential(kind, 1.0), Neighbourhood::N1, 1.5); };
  CHECK(step(PotentialKind::LennardJonesApproximation) == Approx(std::numbers::e / 24).epsilon(1e-8));
  CHECK(step(PotentialKind::LennardJones) == Approx(1.0 / 2592).epsilon(1e-6));
  // delta sum r_ij over six neighbours is their mean
  CHECK(step(PotentialKind::Laplacian) == Approx(1.0 / 6).epsilon(1e-8));
  CHECK(step(PotentialKind::LengthError) == Approx(1.0 / 6).epsilon(1e-8));
}
