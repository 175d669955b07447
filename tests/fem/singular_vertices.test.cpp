#include "fem/singular_vertices.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

std::vector<Point> singular_points(const Mesh& mesh, const Problem& problem) {
  std::vector<Point> points;
  const std::vector<Side> sides = labelled_sides(mesh);
  for (const int v : singular_vertices(SmoothParts(mesh, problem, sides), problem, sides))
    points.push_back(mesh.points[static_cast<std::size_t>(v)]);
  return points;
}

Problem materials(double (*k)(int region)) {
  Problem problem = unit_poisson();
  problem.diffusion = [k](const Point&, int region) { return Diffusion{k(region), 0.0, k(region)}; };
  return problem;
}

}  // namespace

TEST_CASE("convex corners with one condition are not singular", "[fem][singular]") {
  CHECK(singular_points(rectangle_mesh(4, 4), unit_poisson()).empty());
  CHECK(singular_points(random_square(8, 0.24, 1), unit_poisson()).empty());
}

TEST_CASE("reentrant corners are singular, whatever the condition", "[fem][singular]") {
  Problem problem = unit_poisson();
  SECTION("Dirichlet") {}
  SECTION("Neumann") { problem.boundary[Bottom] = neumann({}); }
  CHECK(singular_points(l_shape_mesh(3), problem) == std::vector<Point>{{0, 0}});
}

TEST_CASE("no corner is singular where advection dominates on the mesh", "[fem][singular]") {
  Problem problem = unit_poisson();
  const double speed = GENERATE(1.0, 100.0);  // mesh Peclet numbers up to 0.2 and 20
  problem.velocity = [speed](const Point&, int) { return Vector{speed, 0.0}; };
  CHECK(singular_points(l_shape_mesh(3), problem).size() == (speed == 1.0 ? 1 : 0));
}

TEST_CASE("where given values end is singular but at right angles", "[fem][singular]") {
  Problem problem = unit_poisson();
  problem.boundary[Bottom] = neumann({});
  Mesh mesh = rectangle_mesh(4, 2, {-1, 0}, {1, 1});
  CHECK(singular_points(mesh, problem).empty());
  const auto at_ends = [&](const Point& a, const Point& b) { return a.y == 0.0 && b.y == 0.0 && a.x + b.x > 0.0; };
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto [a, b] = mesh.edges[e];
    if (at_ends(mesh.points[static_cast<std::size_t>(a)], mesh.points[static_cast<std::size_t>(b)]))
      mesh.labels[e] = Right;
  }
  CHECK(singular_points(mesh, problem) == std::vector<Point>{{0, 0}});
}

TEST_CASE("where given values jump is singular", "[fem][singular]") {
  Problem problem = unit_poisson();
  const double jump = GENERATE(0.0, 1e-9, 1e-3, 2.0);
  set_all(problem, dirichlet([](const Point& p, const Vector&, int) { return 1.0 - p.y; }));
  problem.boundary[Bottom] = dirichlet([jump](const Point& p, const Vector&, int) { return 1.0 + jump * p.x; });
  const std::vector<Point> corner{{1, 0}};
  CHECK(singular_points(rectangle_mesh(4, 4), problem) == (jump > 1e-6 ? corner : std::vector<Point>{}));
}

TEST_CASE("interfaces are singular where they end, branch or turn", "[fem][singular]") {
  constexpr int interface = 7;
  const Mesh halves = two_regions(4, interface, 1);  // from the bottom to the top
  CHECK(singular_points(halves, materials([](int) { return 1.0; })).empty());
  CHECK(singular_points(halves, materials([](int region) { return region == 1 ? 3.0 : 1.0; })) ==
        std::vector<Point>{{0.5, 0}, {0.5, 1}});
  // Four quarters of a square.
  Mesh quarters = rectangle_mesh(4, 4);
  for (std::size_t t = 0; t < quarters.triangles.size(); ++t) {
    Point middle;
    for (const int v : quarters.triangles[t]) {
      const Point& p = quarters.points[static_cast<std::size_t>(v)];
      middle = {middle.x + p.x / 3, middle.y + p.y / 3};
    }
    quarters.regions[t] = (middle.x < 0.5 ? 1 : 2) + (middle.y < 0.5 ? 0 : 2);
  }
  for (int i = 0; i < 4; ++i) {
    quarters.edges.insert(quarters.edges.end(), {{5 * i + 2, 5 * i + 7}, {10 + i, 11 + i}});
    quarters.labels.insert(quarters.labels.end(), {interface, interface});
  }
  const Point center{0.5, 0.5};
  const auto only_one = singular_points(quarters, materials([](int region) { return region == 4 ? 9.0 : 1.0; }));
  CHECK(only_one.size() == 3);
  CHECK(std::ranges::count(only_one, center) == 1);
  CHECK(
      singular_points(quarters, materials([](int region) { return region == 1 || region == 4 ? 9.0 : 1.0; })).size() ==
      5);
}

namespace {

/// The lower left quarter of the unit square is region 2, what is around it region 1.
Mesh quarter_in_square() {
  constexpr int interface = 7;
  Mesh mesh = rectangle_mesh(4, 4);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Point middle;
    for (const int v : mesh.triangles[t]) middle = middle + (1.0 / 3.0) * mesh.points[static_cast<std::size_t>(v)];
    mesh.regions[t] = middle.x < 0.5 && middle.y < 0.5 ? 2 : 1;
  }
  for (int i = 0; i < 2; ++i) {
    mesh.edges.insert(mesh.edges.end(), {{5 * i + 2, 5 * i + 7}, {10 + i, 11 + i}});
    mesh.labels.insert(mesh.labels.end(), {interface, interface});
  }
  return mesh;
}

/// With x -> A x, the equation with K becomes that with A K A^T, and a singular vertex stays one.
struct LinearMap {
  double xx, xy, yx, yy;
  Point operator()(const Point& p) const { return {xx * p.x + xy * p.y, yx * p.x + yy * p.y}; }
  Mesh operator()(Mesh mesh) const {
    for (Point& p : mesh.points) p = (*this)(p);
    return mesh;
  }
  Diffusion operator()(const Diffusion& k) const {
    const Vector x{k.xx * xx + k.xy * xy, k.xy * xx + k.yy * xy}, y{k.xx * yx + k.xy * yy, k.xy * yx + k.yy * yy};
    return {xx * x.x + xy * x.y, yx * x.x + yy * x.y, yx * y.x + yy * y.y};
  }
};

std::vector<int> singular_of(const Mesh& mesh, const Problem& problem) {
  const std::vector<Side> sides = labelled_sides(mesh);
  return singular_vertices(SmoothParts(mesh, problem, sides), problem, sides);
}

}  // namespace

TEST_CASE("which vertices are singular does not depend on the coordinates", "[fem][singular]") {
  const auto shape = GENERATE(0, 1, 2);
  const Mesh mesh = shape == 0 ? rectangle_mesh(4, 4) : shape == 1 ? l_shape_mesh(3) : quarter_in_square();
  const LinearMap map = GENERATE(LinearMap{1, 0, 2, 1}, LinearMap{1, 0, -2, 1}, LinearMap{5, 0, 0, 1},
                                 LinearMap{1, 0.3, 0.3, 1}, LinearMap{2, 3, -1, 1});
  Problem before = unit_poisson(), after = unit_poisson();
  for (Problem* problem : {&before, &after}) problem->boundary[Left] = neumann({});
  before.diffusion = [](const Point&, int region) { return region == 2 ? Diffusion{6, 2, 4} : Diffusion{2, -0.5, 1}; };
  after.diffusion = [before, map](const Point& p, int region) { return map(before.diffusion(p, region)); };
  CHECK(singular_of(mesh, before) == singular_of(map(mesh), after));
}

TEST_CASE("a tensor makes corners wider and narrower", "[fem][singular]") {
  // With [[1, c], [c, 1]] the axes are arccos(-c) apart in the metric of the inverse: 154 and 26 degrees for 0.9.
  Problem problem = unit_poisson();
  problem.boundary[Left] = neumann({});
  const double c = GENERATE(0.0, 0.1, 0.2, 0.9, -0.9);
  problem.diffusion = [c](const Point&, int) { return Diffusion{1, c, 1}; };
  const double degrees = 180 / M_PI * std::acos(-std::abs(c));
  const std::vector<Point> wide{{0, c > 0 ? 0.0 : 1.0}};
  CHECK(singular_points(rectangle_mesh(4, 4), problem) == (degrees > 99 ? wide : std::vector<Point>{}));
}

TEST_CASE("where the data of two sides ask for different gradients is singular", "[fem][singular]") {
  constexpr int left_half = 9;
  Mesh mesh = rectangle_mesh(4, 2, {-1, 0}, {1, 1});
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (mesh.labels[e] == Bottom && mesh.points[static_cast<std::size_t>(mesh.edges[e][0])].x < 0)
      mesh.labels[e] = left_half;
  Problem problem = unit_poisson();
  const BoundaryData rising = [](const Point& p, const Vector&, int) { return 1.0 + p.x + p.y; };
  set_all(problem, dirichlet(rising));
  const std::vector<Point> middle{{0, 0}}, none{};
  SECTION("fluxes that jump within a straight side") {
    const double jump = GENERATE(0.0, 1e-2, 3.0);
    set_all(problem, neumann(constant(0.5)));
    problem.boundary[Bottom] = neumann(constant(0.5));
    problem.boundary[left_half] = neumann(constant(0.5 + jump));
    CHECK(singular_points(mesh, problem) == (jump > 0.0 ? middle : none));
  }
  SECTION("one flux that jumps by its expression") {
    set_all(problem, neumann(constant(0.5)));
    problem.boundary[Bottom] = problem.boundary[left_half] =
        neumann([](const Point& p, const Vector&, int) { return p.x < 0.0 ? 1.0 : 0.0; });
    CHECK(singular_points(mesh, problem) == middle);
  }
  SECTION("a Robin condition that ends within a straight side") {
    const double coefficient = GENERATE(0.0, 2.0);
    set_all(problem, robin(constant(2), constant(1)));
    problem.boundary[left_half] = robin(constant(2), constant(1));
    problem.boundary[Bottom] = robin(constant(2.0 - coefficient), constant(1));
    CHECK(singular_points(mesh, problem) == (coefficient > 0.0 ? middle : none));
  }
  SECTION("given values that bend within a straight side") {
    const double bend = GENERATE(0.0, 1e-2, 3.0);
    problem.boundary[left_half] =
        dirichlet([bend](const Point& p, const Vector&, int) { return 1.0 + p.x + p.y + bend * p.x * (1.0 + p.x); });
    CHECK(singular_points(mesh, problem) == (bend > 0.0 ? middle : none));
  }
  SECTION("a flux through a side at right angles to one whose given values say another") {
    const double flux = GENERATE(-1.0, 2.0);  // the first is that of the values
    problem.boundary[left_half] = dirichlet(rising);
    problem.boundary[Left] = neumann(constant(flux));
    CHECK(singular_points(mesh, problem) == (flux == -1.0 ? none : std::vector<Point>{{-1, 0}, {-1, 1}}));
  }
}

TEST_CASE("data of one smooth solution contradict each other nowhere", "[fem][singular]") {
  const BoundaryData value = [](const Point& p, const Vector&, int) { return Wave::value(p); };
  const BoundaryData flux = [](const Point& p, const Vector& n, int) { return dot(n, Wave::gradient(p)); };
  const BoundaryData both = [=](const Point& p, const Vector& n, int region) {
    return flux(p, n, region) + 3.0 * value(p, n, region);
  };
  const BoundaryCondition conditions[] = {dirichlet(value), neumann(flux), robin(constant(3), both)};
  Problem problem = unit_poisson();
  problem.boundary[Bottom] = conditions[GENERATE(0, 1, 2)];
  problem.boundary[Right] = conditions[GENERATE(0, 1, 2)];
  problem.boundary[Top] = conditions[GENERATE(0, 1, 2)];
  problem.boundary[Left] = conditions[GENERATE(0, 1, 2)];
  CHECK(singular_points(rectangle_mesh(5, 4), problem).empty());
  // On 48 chords of a circle.
  Mesh disc;
  disc.points = {{0, 0}};
  for (int k = 0; k < 48; ++k) {
    const double angle = 2.0 * std::acos(-1.0) * k / 48;
    disc.points.push_back({std::cos(angle), std::sin(angle)});
    disc.triangles.push_back({0, 1 + k, 1 + (k + 1) % 48});
    disc.regions.push_back(1);
    disc.edges.push_back({1 + k, 1 + (k + 1) % 48});
    disc.labels.push_back(Bottom);
  }
  CHECK(singular_points(disc, problem).empty());
}

}  // namespace parmesan
