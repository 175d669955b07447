#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "mesher/generate.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/curved_domains.h"
#include "tests/support/domains.h"

using namespace parmesan;

// Domains that are huge, tiny, far away or off by rounding: a right mesh, or a clear refusal.
namespace {

Domain moved(Domain domain, double scale, const Vector& offset) {
  for (Point& p : domain.points) p = offset + scale * p;
  for (Point& p : domain.holes) p = offset + scale * p;
  return domain;
}

GenerateResult mesh_of(const Domain& domain, double h) {
  const ConstantField size(Metric::isotropic(h));
  return generate(domain, size);
}

/// The hole of the square with everything has sides (0.25, 0.05) and (-0.05, 0.25).
constexpr double area_of_everything = 1.0 - (0.25 * 0.25 + 0.05 * 0.05);

/// With points moved by one unit in the last place each, at random; from 0 by one of 1/2.
Domain nudged(const Domain& domain, std::mt19937_64& random) {
  Domain result = domain;
  const auto nudge = [&random](double x) {
    const auto way = static_cast<int>(random() % 3) - 1;
    if (x == 0.0) return way * 0x1p-53;
    return way == 0 ? x : std::nextafter(x, way * std::numeric_limits<double>::infinity());
  };
  for (Point& p : result.points) p = {nudge(p.x), nudge(p.y)};
  return result;
}

}  // namespace

TEST_CASE("domains of any scale are meshed alike, or refused where products would overflow",
          "[mesher][generate][reliability]") {
  const Domain domain = support::square_with_everything();
  const int count = mesh_of(domain, 0.12).mesh.num_triangles();
  for (const int exponent : {-248, -200, -100, -20, 20, 100, 200, 248}) {  // up to about 1e75
    const double scale = std::ldexp(1.0, exponent);
    INFO("scale 2^" << exponent);
    const Mesh mesh = mesh_of(moved(domain, scale, {}), 0.12 * scale).mesh;
    CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
    CHECK(mesh.num_triangles() == Approx(count).epsilon(0.05));
    CHECK(oracle::area_of(mesh) == Approx(area_of_everything * scale * scale).epsilon(1e-14));
  }
  for (const double scale : {1e-150, 1e-100, 1e100, 1e150}) {
    INFO("scale " << scale);
    CHECK_THROWS_WITH(mesh_of(moved(domain, scale, {}), 0.12 * scale), Catch::Contains("scale"));
  }
}

TEST_CASE("small domains far from the origin are meshed as they are rounded", "[mesher][generate][reliability]") {
  for (const Vector& offset : {Vector{5e6, 5e6}, Vector{-3e5, 8e6}, Vector{1e9, 0.0}}) {
    const GenerateResult result = mesh_of(moved(support::square_with_everything(), 1e-3, offset), 1.2e-4);
    INFO("offset " << offset.x << ", " << offset.y);
    CHECK(oracle::problems_of(result.mesh) == std::vector<std::string>{});
    CHECK(oracle::area_of(result.mesh) == Approx(1e-6 * area_of_everything).epsilon(1e-2));
  }
}

TEST_CASE("where the resolution of the coordinates ends there is a mesh with a warning, or a refusal",
          "[mesher][generate][reliability]") {
  for (const double offset : {1e12, 1e13, 1e14}) {  // 8 to 0 units in the last place across
    try {
      const GenerateResult result = mesh_of(moved(support::unit_square(), 1e-3, {offset, offset}), 3e-4);
      CHECK(oracle::problems_of(result.mesh) == std::vector<std::string>{});
      CHECK_FALSE(result.report.warnings.empty());
    } catch (const GeometryError&) {
    } catch (const MeshingError&) {
    }
  }
}

TEST_CASE("a vertex that is all but on a side gives a valid mesh", "[mesher][generate][reliability]") {
  for (const double off : {1e-16, -1e-16, 1e-15, 1e-30}) {
    Domain domain = support::unit_square();
    domain.points.push_back({0.4, off < 0.0 ? 1.0 - 1.2e-16 : off});
    const Mesh mesh = mesh_of(domain, 0.2).mesh;
    CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
    CHECK(oracle::area_of(mesh) == Approx(1.0).epsilon(1e-14));
  }
}

TEST_CASE("corners moved by a unit in the last place change no success, and hardly the mesh",
          "[mesher][generate][reliability]") {
  std::mt19937_64 random(11);
  const Domain domain = support::square_with_everything();
  const Mesh first = mesh_of(domain, 0.07).mesh;
  for (int trial = 0; trial < 8; ++trial) {
    const Mesh mesh = mesh_of(nudged(domain, random), 0.07).mesh;
    CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
    CHECK(std::abs(mesh.num_triangles() - first.num_triangles()) <= first.num_triangles() / 20);
    CHECK(oracle::area_of(mesh) == Approx(oracle::area_of(first)).epsilon(1e-13));
  }
}

TEST_CASE("an aspect of 1e6 across a curved boundary gives a valid mesh", "[mesher][generate][reliability]") {
  for (const double angle : {0.0, 0.5}) {
    const auto thin = [&angle](const Point& p) {
      return Metric::from_sizes(0.5, 5e-7 + 0.5 * std::abs(p.y * std::cos(angle) - p.x * std::sin(angle)), angle);
    };
    const Mesh mesh = generate(support::disc(1.0), CallableField(thin)).mesh;
    CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
  }
}
