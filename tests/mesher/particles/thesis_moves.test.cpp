#include "mesher/particles/thesis_moves.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "mesher/geometry/predicates.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/locate.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/support/domains.h"

using namespace parmesan;

namespace {

/// Any particle that may move or go.
VertexId random_movable(const ParticleSystem& particles, std::mt19937_64& engine) {
  const Triangulation& mesh = particles.mesh();
  for (int i = 0; i < 1000; ++i) {
    const auto v = static_cast<VertexId>(engine() % static_cast<std::uint64_t>(mesh.num_slots()));
    if (mesh.has_vertex(v) && particles.binding(v) != fixed_particle) return v;
  }
  return no_vertex;
}

EdgeId random_edge(const Triangulation& mesh, std::mt19937_64& engine) {
  while (true) {
    const auto q = static_cast<std::int32_t>(engine() % static_cast<std::uint64_t>(mesh.size()));
    if (mesh.is_alive(q)) return {4 * q};
  }
}

/// Do the edges that carry segment s lead from its first point to its last, to rounding on the straight way between?
bool is_chain(const Triangulation& mesh, const Domain& domain, int s) {
  const Segment& segment = domain.segments[std::size_t(s)];
  const Point& a = domain.points[std::size_t(segment.a)];
  const Point& b = domain.points[std::size_t(segment.b)];
  double before = 0.0;
  VertexId v = segment.a;
  while (v != segment.b) {
    VertexId next = no_vertex;
    double least = HUGE_VAL;
    for_each_spoke(mesh, v, [&](EdgeId e) {
      const double t = dot(mesh.point(mesh.dest(e)) - a, b - a) / squared_norm(b - a);
      if (mesh.segment(e) != s || t <= before || t >= least) return;
      least = t;
      next = mesh.dest(e);
    });
    if (next == no_vertex || std::abs(cross(mesh.point(next) - a, b - a)) > 1e-15) return false;
    before = least;
    v = next;
  }
  return true;
}

}  // namespace

TEST_CASE("wild moves, creations and annihilations keep every triangulation valid", "[mesher][particles][thesis]") {
  const Domain domain = support::square_with_everything();
  const CallableField field([](const Point& p) { return Metric::from_sizes(0.02 + 0.2 * p.x, 0.3, 2.0 * p.y); });
  ParticleSystem particles(triangulate(domain), domain, field);
  std::mt19937_64 engine(GENERATE(1U, 2U, 3U));
  const auto draw = [&] { return static_cast<double>(engine() % 20001) / 1e4 - 1.0; };
  for (int i = 0; i < 3000; ++i) {
    const VertexId v = random_movable(particles, engine);
    const auto how = engine() % 2;
    switch (v == no_vertex ? 0 : engine() % 3) {
      case 0:
        create_at(particles, random_edge(particles.mesh(), engine),
                  how == 0 ? CreationPlace::EdgeMidpoint : CreationPlace::Circumcentre);
        break;
      case 1:
        annihilate(particles, v, how == 0 ? Annihilation::Removal : Annihilation::Collapse);
        break;
      default:
        relocate(particles, v, {draw(), draw()}, how == 0 ? Relocation::Reinsert : Relocation::InPlace);
    }
    if (i % 100 != 0) continue;
    const auto problems = check(particles.mesh());
    REQUIRE(problems == std::vector<std::string>{});
    for (int s = 0; s < static_cast<int>(domain.segments.size()); ++s) REQUIRE(is_chain(particles.mesh(), domain, s));
  }
}

TEST_CASE("a particle that is reinserted keeps its number, and goes where it was sent", "[mesher][particles][thesis]") {
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::isotropic(0.1));
  ParticleSystem particles(triangulate(domain), domain, field);
  const VertexId v = particles.create_in_face(some_inside_edge(particles.mesh()), {0.6, 0.6});
  REQUIRE(particles.is_free(v));
  const Point from = particles.mesh().point(v);
  const Vector step{0.13, -0.21};
  CHECK(relocate(particles, v, step, Relocation::Reinsert) == (from + step) - from);
  CHECK(particles.mesh().point(v) == from + step);
}

TEST_CASE("bound particles stay on their slanted segment, free ones inside", "[mesher][particles][thesis]") {
  Domain domain;
  support::add_polygon(domain, {{0.1, 0.2}, {1.3, 0.5}, {0.9, 1.7}}, 1);
  const ConstantField field(Metric::isotropic(0.3));
  ParticleSystem particles(triangulate(domain), domain, field);
  EdgeId first = no_edge;
  for_each_spoke(particles.mesh(), 0, [&](EdgeId e) {
    if (particles.mesh().dest(e) == 1) first = e;
  });
  const VertexId v = create_at(particles, first, CreationPlace::EdgeMidpoint);
  for (int i = 0; i < 50; ++i) relocate(particles, v, {0.1, 0.4 * (i % 3 - 1)}, Relocation::Reinsert);
  const Point& p = particles.mesh().point(v);
  CHECK(std::abs(cross(p - domain.points[0], domain.points[1] - domain.points[0])) < 1e-15);
  CHECK(p.x < 1.3);
  CHECK(check(particles.mesh()) == std::vector<std::string>{});
}

TEST_CASE("an edge whose middle rounds to the wrong side of a flat triangle is not split",
          "[mesher][particles][thesis]") {
  std::mt19937_64 engine(5);
  const auto draw = [&] { return static_cast<double>(engine() % 100000) / 1e5; };
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    const Point a{draw(), draw()};
    const Point b = a + Vector{0.1 + draw(), 0.1 + draw()};
    Point apex = midpoint(a, b);
    apex.y = std::nextafter(apex.y, 9.0);
    Domain domain;
    support::add_polygon(domain, {a, b, apex}, 1);
    if (orient2d(a, b, apex) <= 0.0) continue;
    const ConstantField field(Metric::isotropic(0.1));
    ParticleSystem particles(from_mesh({domain.points, {{0, 1, 2}}, {0}, {{0, 1}, {1, 2}, {2, 0}}, {1, 2, 3}, {}, {}},
                                       std::vector<int>{0, 1, 2}),
                             domain, field);
    for (std::int32_t q = 0; q < 3; ++q)
      refused += create_at(particles, {4 * q}, CreationPlace::EdgeMidpoint) == no_vertex ? 1 : 0;
    CHECK(check(particles.mesh()) == std::vector<std::string>{});
  }
  CHECK(refused > 0);
}

TEST_CASE("a circumcentre behind a constraint is no place for a particle", "[mesher][particles][thesis]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.3, 0.2}, {0.7, 0.2}, {0.5, 0.15}, {0.4, 0.16}});
  domain.segments.push_back({4, 5, 9});
  const ConstantField field(Metric::isotropic(0.1));
  ParticleSystem particles(triangulate(domain), domain, field);
  EdgeId e = no_edge;
  for_each_spoke(particles.mesh(), 4, [&](EdgeId spoke) {
    if (particles.mesh().dest(spoke) == 6) e = spoke;
  });
  REQUIRE(e != no_edge);  // its larger triangle, with the segment, has its center at (0.5, 0.575)
  const VertexId v = create_at(particles, e, CreationPlace::Circumcentre);
  CHECK(particles.mesh().point(v).y < 0.2);
}
