#include "mesher/particles/error_descent.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "mesher/triangulation/check.h"
#include "mesher/triangulation/conversion.h"
#include "tests/oracle/interpolation_error.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

constexpr double size = 0.05;

// u = sin 4x cos 3y: det H takes both signs in the unit square.
double wave(const Point& p) { return std::sin(4.0 * p.x) * std::cos(3.0 * p.y); }
SymmetricTensor wave_hessian(const Point& p) {
  return {-16.0 * wave(p), -12.0 * std::cos(4.0 * p.x) * std::sin(3.0 * p.y), -9.0 * wave(p)};
}

// A disordered square of 20 x 20 cells in the metric of its cells, as particles.
struct Square {
  Square() : domain(support::unit_square()), field(Metric::isotropic(size)) {}
  ParticleSystem particles() const {
    const Mesh mesh = support::random_square(20, 0.2, 3);
    return ParticleSystem(from_mesh(mesh, support::segments_of(mesh)), domain, field);
  }
  Mesh mesh_of(const ParticleSystem& particles) const { return to_mesh(particles.mesh(), std::array{1, 2, 3, 4}).mesh; }

  Domain domain;
  ConstantField field;
};

// The lowest mean ratio in the metric of the square, and the longest and shortest edges there.
struct Shapes {
  double quality = 1.0, longest = 0.0, shortest = std::numeric_limits<double>::infinity();
};
Shapes shapes_of(const Mesh& mesh) {
  Shapes shapes;
  for (const auto& t : mesh.triangles) {
    double squares = 0.0;
    std::array<Point, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.points[static_cast<std::size_t>(t[k])];
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = norm(p[(k + 1) % 3] - p[k]) / size;
      squares += length * length;
      shapes.longest = std::max(shapes.longest, length);
      shapes.shortest = std::min(shapes.shortest, length);
    }
    const double area = 0.5 * cross(p[1] - p[0], p[2] - p[0]) / (size * size);
    shapes.quality = std::min(shapes.quality, 4.0 * std::sqrt(3.0) * area / squares);
  }
  return shapes;
}

}  // namespace

TEST_CASE("the sum that a descent lowers is the squared L2 error of a quadratic", "[mesher][particles]") {
  const Square square;
  ParticleSystem particles = square.particles();
  const CallableTensorField hessian([](const Point&) { return SymmetricTensor{2.0, 1.0, -4.0}; });
  const double exact = oracle::squared_interpolation_error(
      square.mesh_of(particles), [](const Point& p) { return p.x * p.x + p.x * p.y - 2.0 * p.y * p.y; });
  CHECK(ErrorDescent(particles, hessian).squared_error() == Approx(exact).epsilon(1e-10));
}

TEST_CASE("no move and no flip raises the error, and the mesh stays valid", "[mesher][particles]") {
  const Square square;
  ParticleSystem particles = square.particles();
  // The rippled one varies so much within an edge that Newton's steps often lead uphill.
  const double ripple = GENERATE(0.0, 0.9);
  const CallableTensorField hessian([ripple](const Point& p) {
    return (1.0 + ripple * std::sin(300.0 * p.x) * std::sin(300.0 * p.y)) * wave_hessian(p);
  });
  ErrorDescent descent(particles, hessian);
  double before = descent.squared_error();
  int flips = 0, moves = 0;
  for (int i = 0; i < 6; ++i) {
    flips += descent.flip_edges();
    const double flipped = descent.squared_error();
    CHECK(flipped <= before * (1.0 + 1e-13));
    moves += descent.move_particles();
    const double moved = descent.squared_error();
    CHECK(moved < flipped);
    CHECK(check(particles.mesh()).empty());
    before = moved;
  }
  CHECK(flips > 20);
  CHECK(moves > 500);
}

TEST_CASE("lower_error lowers the true L2 error of a function", "[mesher][particles]") {
  const Square square;
  ParticleSystem particles = square.particles();
  const double before = oracle::squared_interpolation_error(square.mesh_of(particles), wave);
  const CallableTensorField hessian(wave_hessian);
  lower_error(particles, hessian);
  const Mesh mesh = square.mesh_of(particles);
  CHECK(oracle::problems_of(mesh).empty());
  CHECK(oracle::area_of(mesh) == Approx(1.0).epsilon(1e-12));
  CHECK(oracle::squared_interpolation_error(mesh, wave) < 0.6 * before);
}

TEST_CASE("what keeps the limits on quality and lengths goes on to keep them", "[mesher][particles]") {
  const Square square;
  ParticleSystem particles = square.particles();
  const Shapes before = shapes_of(square.mesh_of(particles));
  const ErrorDescentOptions limits{.min_quality = before.quality,
                                   .max_length = std::max(before.longest, 1.0 / before.shortest)};
  // One direction only matters: without limits triangles would become needles.
  const CallableTensorField hessian([](const Point&) { return SymmetricTensor{100.0, 0.0, 1.0}; });
  lower_error(particles, hessian, limits);
  const Shapes after = shapes_of(square.mesh_of(particles));
  CHECK(after.quality >= limits.min_quality * (1.0 - 1e-12));
  CHECK(after.longest <= limits.max_length * (1.0 + 1e-12));
  CHECK(after.shortest >= (1.0 - 1e-12) / limits.max_length);

  SECTION("and without limits they would be broken") {
    ParticleSystem loose = square.particles();
    lower_error(loose, hessian, {.min_quality = -2.0, .max_length = 100.0});
    CHECK(check(loose.mesh()).empty());
    CHECK(shapes_of(square.mesh_of(loose)).quality < 0.7 * limits.min_quality);
    CHECK(shapes_of(square.mesh_of(loose)).longest > 1.2 * limits.max_length);
  }
}

TEST_CASE("particles on segments slide along them, fixed ones stay", "[mesher][particles]") {
  const Square square;
  ParticleSystem particles = square.particles();
  const ParticleSystem start = particles;
  const CallableTensorField hessian(wave_hessian);
  lower_error(particles, hessian);
  int slid = 0;
  for (VertexId v = 0; v < particles.mesh().num_slots(); ++v) {
    const Point& from = start.mesh().point(v);
    const Point& to = particles.mesh().point(v);
    if (particles.binding(v) == fixed_particle) CHECK(to == from);
    if (particles.binding(v) < 0) continue;
    const bool level = particles.binding(v) % 2 == 0;  // bottom and top
    CHECK((level ? to.y == from.y : to.x == from.x));
    slid += to != from;
  }
  CHECK(slid > 60);
}

TEST_CASE("where the Hessian is not finite nothing changes", "[mesher][particles]") {
  const double bad = GENERATE(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN());
  const Square square;
  ParticleSystem particles = square.particles();
  const CallableTensorField hessian([bad](const Point& p) {
    return p.x < 0.5 ? SymmetricTensor{bad, 0.0, bad} : wave_hessian(p);
  });
  const ParticleSystem start = particles;
  lower_error(particles, hessian);
  CHECK(oracle::problems_of(square.mesh_of(particles)).empty());
  int moved = 0;
  for (VertexId v = 0; v < particles.mesh().num_slots(); ++v) {
    const Point& from = start.mesh().point(v);
    if (from.x < 0.5) CHECK(particles.mesh().point(v) == from);
    moved += particles.mesh().point(v) != from;
  }
  CHECK(moved > 100);
}

TEST_CASE("no particle goes where the Hessian is not finite", "[mesher][particles]") {
  const Square square;
  ParticleSystem particles = square.particles();
  // A stripe in each cell; the vertices are within 0.2 cells of its sides.
  const auto is_bad = [](const Point& p) { return std::abs(p.x / size - std::floor(p.x / size) - 0.3) < 0.05; };
  const CallableTensorField hessian([&](const Point& p) {
    return is_bad(p) ? std::numeric_limits<double>::quiet_NaN() * wave_hessian(p) : wave_hessian(p);
  });
  lower_error(particles, hessian);
  for (VertexId v = 0; v < particles.mesh().num_slots(); ++v) CHECK_FALSE(is_bad(particles.mesh().point(v)));
}

TEST_CASE("a descent leaves constrained edges alone", "[mesher][particles]") {
  // Two triangles whose diagonal (0, 0) to (1, 1) the function u = (x + y)^2 would flip: it varies along it only.
  Mesh mesh = support::rectangle_mesh(1, 1);
  Domain domain = support::unit_square();
  const bool constrained = GENERATE(false, true);
  if (constrained) {
    domain.segments.push_back({0, 2, 5});
    mesh.edges.push_back({0, 3});
    mesh.labels.push_back(5);
  }
  const ConstantField field(Metric::isotropic(1.0));
  ParticleSystem particles(from_mesh(mesh, support::segments_of(mesh)), domain, field);
  const CallableTensorField hessian([](const Point&) { return SymmetricTensor{2.0, 2.0, 2.0}; });
  CHECK(ErrorDescent(particles, hessian).flip_edges() == (constrained ? 0 : 1));
}
