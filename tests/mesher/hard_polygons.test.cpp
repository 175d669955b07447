#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/generate.h"
#include "mesher/geometry/clean.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/oracle/domain_cover.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/box.h"
#include "tests/support/hard_polygons.h"

using namespace parmesan;

namespace {

/// A polygon, and the area of its triangulation.
class Case {
 public:
  explicit Case(const Domain& domain)
      : domain_(clean(domain).domain), box_(support::box_of(domain.points)), area_(triangulated_area()) {}

  const support::Box& box() const { return box_; }

  void check_generated(const MetricField& field) const {
    const Mesh mesh = generate(domain_, field).mesh;
    check_mesh(mesh);
    const double rounding = 1e-14 * box_.diameter() * box_.largest();  // vertices on slanted segments
    CHECK(std::abs(oracle::area_of(mesh) - area_) < 1e-9 * area_ + rounding);
  }

 private:
  Domain domain_;
  support::Box box_;
  double area_;

  double triangulated_area() const {
    const Triangulation t = triangulate(domain_);
    for (const auto& problem : check(t, {.is_delaunay = true})) FAIL_CHECK(problem);
    std::vector<int> labels;
    for (const Segment& s : domain_.segments) labels.push_back(s.label);
    const Mesh mesh = to_mesh(t, labels).mesh;
    check_mesh(mesh);
    return oracle::area_of(mesh);
  }

  void check_mesh(const Mesh& mesh) const {
    for (const auto& problem : oracle::problems_of(mesh)) FAIL_CHECK(problem);
    for (const auto& problem : oracle::problems_of_cover(mesh, domain_, 0x1p-49 * box_.largest())) FAIL_CHECK(problem);
  }
};

void check_numbers(std::uint32_t count, std::uint32_t layers) {
  for (std::uint32_t number = 0; number < count; ++number) {
    const support::HardPolygon polygon = support::hard_polygon(number);
    INFO(polygon.name << " " << number);
    const Case made(polygon.domain);
    made.check_generated(ConstantField(Metric::isotropic(0.3 * made.box().diameter())));
    if (number < layers) made.check_generated(support::layer_in(made.box()));
  }
}

}  // namespace

TEST_CASE("hard polygons are triangulated and meshed whole", "[mesher][generate]") { check_numbers(350, 35); }

TEST_CASE("ten thousand hard polygons are triangulated and meshed whole", "[mesher][generate][slow]") {
  check_numbers(10'000, 350);
}
