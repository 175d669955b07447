#include "mesher/particles/motion.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "mesher/triangulation/check.h"
#include "mesher/triangulation/conversion.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

// A square of n x n cells with moved inner vertices, as particles.
struct MovedSquare {
  MovedSquare(int n, double disorder, const Metric& metric) : domain(support::unit_square()), field(metric) {
    const Mesh mesh = support::random_square(n, disorder, 3);
    triangulation = from_mesh(mesh, support::segments_of(mesh));
  }
  ParticleSystem particles() const { return ParticleSystem(triangulation, domain, field); }

  Domain domain;
  ConstantField field;
  Triangulation triangulation;
};

double worst_star(const ParticleSystem& particles) {
  Star star;
  double worst = 1.0;
  for (VertexId v = 0; v < particles.mesh().num_slots(); ++v) {
    star.gather(particles, v);
    worst = std::min(worst, star.min_quality(particles.mesh().point(v), particles.metric(v)));
  }
  return worst;
}

}  // namespace

TEST_CASE("sweeps never invert a triangle, whatever the metric", "[mesher][particles]") {
  const Metric metric = GENERATE(Metric::isotropic(0.05), Metric::isotropic(0.5), Metric::from_sizes(0.01, 0.3, 0.5));
  const Motion motion = GENERATE(Motion::Force, Motion::IdealApex);
  const MovedSquare square(20, 0.24, metric);
  ParticleSystem particles = square.particles();
  const std::vector<double> targets(static_cast<std::size_t>(particles.mesh().num_slots()),
                                    std::numeric_limits<double>::quiet_NaN());
  for (int i = 0; i < 10; ++i) {
    sweep(particles, Blocks(particles), 0, targets, {.motion = motion});
    CHECK(check(particles.mesh()).empty());
  }
}

TEST_CASE("ideal-apex sweeps lift the worst star of a disordered mesh", "[mesher][particles]") {
  const MovedSquare square(20, 0.24, Metric::isotropic(0.05));
  ParticleSystem particles = square.particles();
  const double before = worst_star(particles);
  const std::vector<double> targets(static_cast<std::size_t>(particles.mesh().num_slots()),
                                    std::numeric_limits<double>::quiet_NaN());
  for (int i = 0; i < 5; ++i) sweep(particles, Blocks(particles), 0, targets, {.motion = Motion::IdealApex});
  CHECK(worst_star(particles) > before);
}

TEST_CASE("momentum goes on with a share of the last move, where the metric is resolved", "[mesher][particles]") {
  const MovedSquare square(4, 0.0, Metric::isotropic(0.25));
  const std::vector<double> targets(25, std::numeric_limits<double>::quiet_NaN());
  const VertexId centre = 2 * 5 + 2;
  const auto moved_by = [&](double momentum) {
    ParticleSystem particles = square.particles();
    particles.keep_velocities();
    particles.set_velocity(centre, {0.02, 0.0});
    sweep(particles, Blocks(particles), 0, targets, {.momentum = momentum});
    return particles.mesh().point(centre) - Point{0.5, 0.5};
  };
  CHECK((moved_by(0.5) - moved_by(0.0)).x == Approx(0.01).margin(0.002));
  CHECK(moved_by(0.5).y == Approx(moved_by(0.0).y).margin(1e-3));
}

TEST_CASE("a sweep of resolved stars leaves the others where they are", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  // Sizes jump by 2 at x = 0.45: the stars of the columns x = 0.25 and x = 0.5 cross it.
  const CallableField field([](const Point& p) { return Metric::isotropic(p.x < 0.45 ? 0.2 : 0.4); });
  const Mesh mesh = support::random_square(4, 0.2, 3);
  ParticleSystem particles(from_mesh(mesh, support::segments_of(mesh)), domain, field);
  const std::vector<double> targets(25, std::numeric_limits<double>::quiet_NaN());
  Star star;
  sweep(particles, Blocks(particles), 0, targets, {.only_resolved = true});
  int left_alone = 0;
  for (VertexId v = 0; v < 25; ++v) {
    star.gather(particles, v);
    if (!particles.is_free(v) || star.is_resolved(particles.mesh().point(v), particles.metric(v))) continue;
    CHECK(particles.mesh().point(v) == mesh.points[static_cast<std::size_t>(v)]);
    ++left_alone;
  }
  CHECK(left_alone >= 6);
  CHECK(left_alone < 9);
}

TEST_CASE("fixed particles stay, bound ones go to their target and no further", "[mesher][particles]") {
  const MovedSquare square(4, 0.0, Metric::isotropic(0.25));
  ParticleSystem particles = square.particles();
  std::vector<double> targets(static_cast<std::size_t>(particles.mesh().num_slots()),
                              std::numeric_limits<double>::quiet_NaN());
  // Vertex 1 lies at (0.25, 0) on the bottom segment, which runs from x = 0 to x = 1.
  targets[1] = 0.3;
  sweep(particles, Blocks(particles), 0, targets);
  CHECK(particles.mesh().point(1) == Point{0.3, 0.0});
  CHECK(particles.mesh().point(2) == Point{0.5, 0.0});
  CHECK(particles.mesh().point(0) == Point{0.0, 0.0});
}

TEST_CASE("try_move halves a step that would turn a triangle over, and gives up on hopeless ones",
          "[mesher][particles]") {
  const MovedSquare square(4, 0.0, Metric::isotropic(0.25));
  ParticleSystem particles = square.particles();
  const VertexId centre = 2 * 5 + 2;
  Star star;
  star.gather(particles, centre);
  // The star is one cell wide: 0.4 to the right is outside, 0.2 and 0.1 inside.
  CHECK(try_move(particles, star, centre, {0.4, 0.0}, Update::Now));
  CHECK(particles.mesh().point(centre).x < 0.75);
  CHECK(particles.mesh().point(centre).x > 0.5);
  star.gather(particles, centre);
  CHECK_FALSE(try_move(particles, star, centre, {100.0, 0.0}, Update::Now));
}
