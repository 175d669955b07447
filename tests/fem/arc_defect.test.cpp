#include "fem/arc_defect.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/galerkin_error.h"
#include "fem/norms.h"
#include "fem/recovery.h"
#include "fem/solve.h"
#include "mesher/arc_heights.h"
#include "mesher/generate.h"
#include "mesher/metric/metric_field.h"
#include "tests/fem/manufactured.h"
#include "tests/support/curved_domains.h"

namespace parmesan {
namespace {

using namespace support;

constexpr int circle_label = 9;
constexpr double radius = 0.3;

/// The square from -1 to 1 with a circle inside: a hole, or region 1.
Domain square_with_circle(bool is_hole) {
  Domain domain;
  domain.points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  domain.segments = {{0, 1, Bottom}, {1, 2, Right}, {2, 3, Top}, {3, 0, Left}};
  add_closed_curve(domain, circle({}, radius), circle_label);
  if (is_hole) {
    domain.holes = {{0, 0}};
  } else {
    domain.regions = {{{0, 0}, 1}};
  }
  return domain;
}

/// cos m phi (r^m + inner r^-m) outside of the circle, cos m phi  across r^m inside.
struct Multipole {
  int m = 1;
  double inner = 0.0;
  double across = 1.0;
  double limit = 0.0;  // the radius of the circle, where there is an inside

  double value(const Point& p) const {
    const double r = norm(p), angle = m * std::atan2(p.y, p.x);
    return (r < limit ? across * std::pow(r, m) : std::pow(r, m) + inner * std::pow(r, -m)) * std::cos(angle);
  }
  Vector gradient(const Point& p) const {
    const double r = norm(p), phi = std::atan2(p.y, p.x);
    const double f = r < limit ? across * std::pow(r, m) : std::pow(r, m) + inner * std::pow(r, -m);
    const double slope =
        m * (r < limit ? across * std::pow(r, m - 1) : std::pow(r, m - 1) - inner * std::pow(r, -m - 1));
    const Vector radial{std::cos(phi), std::sin(phi)}, around{-radial.y, radial.x};
    return slope * std::cos(m * phi) * radial - m * f / r * std::sin(m * phi) * around;
  }
  ExactFunction exact() const {
    const Multipole u = *this;
    return {[u](const Point& p) { return u.value(p); }, [u](const Point& p) { return u.gradient(p); }};
  }
};

Problem laplace(const Multipole& u) {
  Problem problem;
  for (const int label : {Bottom, Right, Top, Left})
    problem.boundary[label] = dirichlet([u](const Point& p, const Vector&, int) { return u.value(p); });
  return problem;
}

/// An inclusion that conducts k times as well as what is around it.
struct Inclusion {
  Multipole exact;
  Problem problem;

  Inclusion(int m, double k) {
    const double r = std::pow(radius, 2 * m);
    exact = {m, r * (1 - k) / (1 + k), 2 / (1 + k), radius};
    problem = laplace(exact);
    problem.diffusion = [k](const Point&, int region) { return region == 1 ? Diffusion{k, 0, k} : identity_tensor; };
  }
};

struct Effectivities {
  double l2 = 0.0;
  double h1 = 0.0;
  double l2_without = 0.0;  // arcs
};

Effectivities effectivities(const Domain& domain, const Problem& problem, const ExactFunction& exact, double size) {
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(size))).mesh;
  DiscreteProblem discrete(mesh, problem, {}, arc_heights(mesh, domain));
  DiscreteProblem without(mesh, problem);
  const Solution solution = solve(discrete);
  const ErrorNorms error = error_norms(mesh, solution.values, exact);
  const EstimatedError estimate = estimate_error(discrete, solution.values).norms;
  return {estimate.l2 / error.l2, estimate.h1 / error.h1, estimate_error(without, solution.values).norms.l2 / error.l2};
}

}  // namespace

TEST_CASE("what chords of interfaces add to the error is estimated", "[fem][estimate][curves]") {
  const auto [k, m] = GENERATE(table<double, int>({{0.01, 2}, {0.2, 1}, {100.0, 1}}));
  const Inclusion inclusion(m, k);
  const Effectivities e = effectivities(square_with_circle(false), inclusion.problem, inclusion.exact.exact(), 0.04);
  INFO("k " << k << ", m " << m << ", without " << e.l2_without);
  CHECK(e.l2 == Approx(1.0).margin(0.05));
  CHECK(e.h1 == Approx(1.0).margin(0.1));
}

TEST_CASE("sources that jump where an interface is, not at its chords, are each side's own", "[fem][curves]") {
  // u = r^2 inside, where K = 1, and r^2 / 5 plus a constant outside, where K = 5: -4 on both sides, as -K div grad u.
  constexpr double conductive = 5.0;
  const auto is_inside = [](const Point& p) { return norm(p) < radius; };
  const ExactFunction exact{[=](const Point& p) {
                              const double r2 = squared_norm(p);
                              return is_inside(p) ? r2 : r2 / conductive + (1 - 1 / conductive) * radius * radius;
                            },
                            [=](const Point& p) { return (is_inside(p) ? 2.0 : 2.0 / conductive) * p; }};
  Problem problem;
  problem.diffusion = [](const Point&, int region) {
    return region == 1 ? identity_tensor : Diffusion{conductive, 0, conductive};
  };
  problem.source = [=](const Point& p, int region) {
    return -(region == 1 ? 1.0 : conductive) * (is_inside(p) ? 4.0 : 4.0 / conductive);
  };
  for (const int label : {Bottom, Right, Top})
    problem.boundary[label] =
        neumann([=](const Point& p, const Vector& n, int) { return conductive * dot(n, exact.gradient(p)); });
  problem.boundary[Left] = dirichlet([exact](const Point& p, const Vector&, int) { return exact.value(p); });
  const Domain domain = square_with_circle(false);
  const Effectivities e = effectivities(domain, problem, exact, 0.06);
  CHECK(e.l2 == Approx(1.0).margin(0.05));
  CHECK(e.h1 == Approx(1.0).margin(0.1));
  problem.correct_defect = true;
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(0.06))).mesh;
  DiscreteProblem discrete(mesh, problem, {}, arc_heights(mesh, domain));
  const double interpolated = error_norms(mesh, interpolate(mesh, exact.value), exact).l2;
  CHECK(error_norms(mesh, solve(discrete).values, exact).l2 < 1.1 * interpolated);
}

TEST_CASE("what chords of holes add to the error is estimated", "[fem][estimate][curves]") {
  const int m = GENERATE(1, 2);
  Multipole u{m, std::pow(radius, 2 * m)};  // without flux through the circle
  BoundaryCondition condition = neumann({});
  SECTION("without flux") {}
  SECTION("with a given flux") {
    u.inner = 0.0;
    condition = neumann([u](const Point& p, const Vector&, int) { return -dot(u.gradient(p), p) / norm(p); });
  }
  SECTION("with a flux that depends on the solution") {
    u.inner *= 0.5;
    const double slope = -m * std::pow(radius, m - 1) * 0.5, value = std::pow(radius, m) * 1.5;
    condition = robin([=](const Point&, const Vector&, int) { return -slope / value; }, {});
  }
  Problem problem = laplace(u);
  problem.boundary[circle_label] = condition;
  const Effectivities e = effectivities(square_with_circle(true), problem, u.exact(), 0.04);
  INFO("m " << m << ", without " << e.l2_without);
  CHECK(e.l2 == Approx(1.0).margin(0.05));
  CHECK(e.h1 == Approx(1.0).margin(0.1));
}

TEST_CASE("corrected solutions feel no chords", "[fem][curves][correction]") {
  Inclusion inclusion(1, 0.01);
  inclusion.problem.correct_defect = true;
  const ExactFunction exact = inclusion.exact.exact();
  const Domain domain = square_with_circle(false);
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(0.06))).mesh;
  DiscreteProblem discrete(mesh, inclusion.problem, {}, arc_heights(mesh, domain));
  const double interpolated = error_norms(mesh, interpolate(mesh, exact.value), exact).l2;
  CHECK(error_norms(mesh, solve(discrete).values, exact).l2 < 1.1 * interpolated);
  CHECK(error_norms(mesh, solve(mesh, inclusion.problem).values, exact).l2 > 1.3 * interpolated);
}

TEST_CASE("what chords of a disc add to the error is estimated, sources and transport too", "[fem][estimate][curves]") {
  // u = r^2 on the unit disc with b = (y, -x) + (1, 0), c = 2, and n.grad u + u = 3.
  Problem problem;
  problem.velocity = [](const Point& p, int) { return Vector{p.y + 1.0, -p.x}; };
  problem.reaction = [](const Point&, int) { return 2.0; };
  problem.source = [](const Point& p, int) { return -4.0 + 2.0 * p.x + 2.0 * squared_norm(p); };
  const auto constant = [](double c) { return [c](const Point&, const Vector&, int) { return c; }; };
  problem.boundary[1] = robin(constant(1.0), constant(3.0));
  const ExactFunction exact{[](const Point& p) { return squared_norm(p); }, [](const Point& p) { return 2.0 * p; }};
  const Effectivities e = effectivities(disc(1.0), problem, exact, 0.08);
  INFO("without " << e.l2_without);
  CHECK(e.l2 == Approx(1.0).margin(0.05));
  CHECK(e.h1 == Approx(1.0).margin(0.1));
}

}  // namespace parmesan
