#include "mesher/metric/boundary_alignment.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/errors.h"
#include "tests/support/domains.h"

using namespace parmesan;

TEST_CASE("on a segment an eigenvector lies along it; sizes stay everywhere; far off nothing turns",
          "[mesher][metric]") {
  Domain domain;
  support::add_polygon(domain, {{0, 0}, {4, 1}, {3, 5}, {-1, 4}}, 1);  // a square of side sqrt 17
  const double angle = GENERATE(0.0, 0.4, 0.9, 1.5, 2.3, 3.0);
  const ConstantField field(Metric::from_sizes(0.5, 0.1, angle));
  const BoundaryAlignedField aligned(field, domain, 2.0);
  const Vector along{4, 1};
  const Metric on_side = aligned.at(Point{2, 0.5});
  CHECK(dot(along, on_side.tensor() * Vector{-1, 4}) == Approx(0.0).margin(1e-9));
  const Metric center = aligned.at(Point{1.5, 2.5});
  CHECK(center.tensor() == field.at(Point{1.5, 2.5}).tensor());
  for (const Point& p : {Point{2, 0.5}, Point{2, 0.55}, Point{2, 0.7}, Point{0, 0}, Point{1.5, 2.5}}) {
    const Eigen2 e = eigen_decomposition(aligned.at(p).tensor());
    CHECK(e.l1 == Approx(100.0).epsilon(1e-9));
    CHECK(e.l2 == Approx(4.0).epsilon(1e-9));
  }
}

TEST_CASE("the turn is the smaller one and fades with the distance", "[mesher][metric]") {
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::from_sizes(0.2, 0.05, 0.3));
  const BoundaryAlignedField aligned(field, domain, 3.0);
  double before = -1.0;
  for (const double y : {0.0, 0.03, 0.06, 0.1, 0.14}) {
    // axis is that of the larger eigenvalue, across: the long side's angle goes from 0 to 0.3.
    const Vector axis = eigen_decomposition(aligned.at(Point{0.5, y}).tensor()).axis;
    const double turned = std::atan(-axis.x / axis.y);
    CHECK(turned > before);
    CHECK(turned <= 0.3 + 1e-12);
    before = turned;
  }
  CHECK(before > 0.2);
}

TEST_CASE("an isotropic metric stays; a reach that is not positive is refused", "[mesher][metric][errors]") {
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::isotropic(0.1));
  const SymmetricTensor t = BoundaryAlignedField(field, domain, 2.0).at(Point{0.01, 0.5}).tensor();
  CHECK(t.xx == Approx(100.0));
  CHECK(t.xy == Approx(0.0).margin(1e-9));
  CHECK_THROWS_AS(BoundaryAlignedField(field, domain, 0.0), InputError);
  CHECK_THROWS_AS(BoundaryAlignedField(field, domain, NAN), InputError);
}
