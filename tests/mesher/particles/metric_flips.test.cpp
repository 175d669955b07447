#include "mesher/particles/metric_flips.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/geometry/predicates.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/conversion.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

/// Twice the area over half the sum of squared sides: sqrt3 / 3 for the equilateral triangle.
double shape(const Point& a, const Point& b, const Point& c) {
  return 2.0 * cross(b - a, c - a) / (squared_norm(b - a) + squared_norm(c - b) + squared_norm(a - c));
}

}  // namespace

TEST_CASE("flips in a constant metric give the Delaunay triangulation of the stretched plane", "[mesher][particles]") {
  const double h1 = GENERATE(1.0, 0.1, 0.01);
  const double angle = GENERATE(0.0, 0.8);
  const Mesh mesh = support::random_square(20, 0.2, 7);
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::from_sizes(h1, 1.0, angle));
  ParticleSystem particles(from_mesh(mesh, support::segments_of(mesh)), domain, field);
  CHECK(flip_all(particles) > 0);
  CHECK(check(particles.mesh()).empty());
  CHECK(flip_all(particles) == 0);

  // The map that makes the metric Euclidean; the exact in-circle test there is the oracle. Near
  // ties may go either way by rounding, so a clear violation is asked for; slivers are excused, as
  // they may be kept rather than made worse.
  const auto stretched = [&](VertexId v) {
    const Point& p = particles.mesh().point(v);
    const Vector axis{std::cos(angle), std::sin(angle)};
    return Point{dot(p, axis) / h1, cross(axis, p)};
  };
  const Triangulation& t = particles.mesh();
  int violations = 0;
  for (std::int32_t q = 0; q < t.size(); ++q) {
    const EdgeId e{4 * q};
    if (!t.is_alive(q) || t.is_constrained(e)) continue;
    const Point a = stretched(t.org(e));
    const Point b = stretched(t.dest(e));
    const Point c = stretched(t.dest(t.onext(e)));
    const Point d = stretched(t.dest(t.oprev(e)));
    const double scale = std::pow(squared_norm(c - d) + squared_norm(a - b), 2);
    const bool convex = orient2d(d, c, a) > 0.0 && orient2d(c, d, b) > 0.0;
    const double worst = std::min({shape(a, b, c), shape(b, a, d), shape(d, c, a), shape(c, d, b)});
    if (convex && worst > 0.1 && incircle(a, b, c, d) > 1e-8 * scale) ++violations;
  }
  CHECK(violations == 0);
}
