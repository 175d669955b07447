#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "adapt/case.h"
#include "case_support.h"

namespace parmesan {
namespace {

using support::case_text;
using support::issue_text;
using support::kZeroBoundary;

Case with_problem(const std::string& problem, const std::string& rest = "") {
  return parse_case(case_text(problem, rest), "case.json");
}

std::string cases_file(const std::string& name) {
  return std::string(PARMESAN_SOURCE_DIR) + "/cases/" + name + ".json";
}

/// Fourth-order central differences of a function along a direction.
template <class F>
double first_difference(F f, double h) {
  return (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
}
template <class F>
double second_difference(F f, double h) {
  return (16.0 * (f(h) + f(-h)) - (f(2.0 * h) + f(-2.0 * h)) - 30.0 * f(0.0)) / (12.0 * h * h);
}

/// -k Laplace u + b.grad u by differences of values of u alone.
double differenced_source(const Expression& u, const Point& p, double k, const Vector& b, double h) {
  const auto along_x = [&](double t) { return u.value({p.x + t, p.y}); };
  const auto along_y = [&](double t) { return u.value({p.x, p.y + t}); };
  return -k * (second_difference(along_x, h) + second_difference(along_y, h)) + b.x * first_difference(along_x, h) +
         b.y * first_difference(along_y, h);
}

struct Layer {
  std::string name;
  double k;
  Vector b;
  double h;          // step of differences: a fraction of the layer
  Point p;           // inside the layer
  double tolerance;  // relative
};

}  // namespace

TEST_CASE("The derived sources of the cases are those of finite differences", "[adapt][case]") {
  const std::vector<Layer> layers{
      {"wave_front", 1.0, {}, 1e-3, {0.45, 0.43}, 1e-5},
      {"wave_front_steep", 1.0, {}, 2e-5, {0.4452, 0.4445}, 1e-4},
      {"boundary_layer", 1e-3, {2.0, 1.0}, 3e-5, {0.998, 0.3}, 1e-5},
      {"boundary_layer", 1e-3, {2.0, 1.0}, 1e-3, {-0.3, 0.2}, 1e-5},
      {"internal_layer", 1e-4, {std::cos(M_PI / 6), std::sin(M_PI / 6)}, 2e-4, {0.3, 0.38}, 1e-4},
  };
  for (const Layer& layer : layers) {
    INFO(layer.name);
    const Case c = read_case(cases_file(layer.name));
    const double expected = differenced_source(*c.exact, layer.p, layer.k, layer.b, layer.h);
    REQUIRE(std::abs(expected) > 1e-3);
    CHECK(c.problem.source(layer.p, 0) == Approx(expected).epsilon(layer.tolerance));
  }
}

TEST_CASE("The exact solution of the L is harmonic, continuous inside and zero on the corner's sides",
          "[adapt][case]") {
  const Expression u = *read_case(cases_file("l_shape")).exact;
  for (const double t : {0.1, 0.5, 1.0}) {
    CHECK(u.value({t, 0.0}) == Approx(0.0).margin(1e-15));
    CHECK(u.value({0.0, -t}) == Approx(0.0).margin(1e-15));
    // theta = 3 pi / 4 is the middle of the opening: sin(pi / 2) = 1
    CHECK(u.value({-t / std::sqrt(2.0), t / std::sqrt(2.0)}) == Approx(std::pow(t, 2.0 / 3.0)).epsilon(1e-14));
    // theta = pi: sin(2 pi / 3), and no cut there
    CHECK(u.value({-t, 1e-12}) == Approx(u.value({-t, -1e-12})).epsilon(1e-10));
    CHECK(u.value({-t, 0.0}) == Approx(std::pow(t, 2.0 / 3.0) * std::sqrt(0.75)).epsilon(1e-14));
  }
  const Jet jet = u.jet({-0.3, -0.4});
  CHECK(jet.xx + jet.yy == Approx(0.0).margin(1e-13));
}

TEST_CASE("A derived source knows tensors, variable coefficients, velocity and reaction", "[adapt][case]") {
  // u = x^2 y, K = [[1+x, y], [y, 2]]: K grad u = (2xy + 3 x^2 y, 2 x y^2 + 2 x^2), its divergence 2y + 10 x y.
  // b = (3, x): 6xy + x^3. c = y: x^2 y^2.
  const Case c = with_problem(R"("diffusion": [["1+x", "y"], ["y", 2]], "velocity": [3, "x"], "reaction": "y",
      "exact": "x^2*y", "boundary": {"left": {"dirichlet": "exact"}, "right": {"neumann": "exact"},
      "top": {"robin": {"coefficient": "1+x", "value": "exact"}}, "bottom": {"neumann": "exact + nx + 2*y"}})");
  const double x = 0.7;
  const double y = 0.4;
  const Point p{x, y};
  CHECK(c.problem.source(p, 0) == Approx(-(2 * y + 10 * x * y) + 6 * x * y + x * x * x + x * x * y * y).epsilon(1e-14));
  CHECK(c.problem.diffusion(p, 0).xx == 1.7);
  CHECK(c.problem.diffusion(p, 0).xy == 0.4);
  CHECK(c.problem.diffusion(p, 0).yy == 2.0);
  CHECK(c.problem.velocity(p, 0) == Point{3.0, 0.7});
  const auto condition = [&c](const std::string& name) {
    for (const auto& [label, known] : c.domain.label_names) {
      if (known == name) return c.problem.boundary.at(label);
    }
    throw std::logic_error(name);
  };
  CHECK(condition("left").value(p, {-1.0, 0.0}, 0) == Approx(x * x * y).epsilon(1e-14));
  const double flux_x = 2 * x * y + 3 * x * x * y;
  const double flux_y = 2 * x * y * y + 2 * x * x;
  CHECK(condition("right").value(p, {1.0, 0.0}, 0) == Approx(flux_x).epsilon(1e-14));
  CHECK(condition("top").kind == BoundaryKind::Robin);
  CHECK(condition("top").value(p, {0.0, 1.0}, 0) == Approx(flux_y + (1 + x) * x * x * y).epsilon(1e-14));
  CHECK(condition("top").coefficient(p, {0.0, 1.0}, 0) == 1.7);
  CHECK(condition("bottom").value(p, {0.6, -0.8}, 0) ==
        Approx(0.6 * flux_x - 0.8 * flux_y + 0.6 + 2 * y).epsilon(1e-14));
}

TEST_CASE("Coefficients that are zero are left empty", "[adapt][case]") {
  const Case c = with_problem(kZeroBoundary);
  CHECK_FALSE(c.problem.velocity);
  CHECK_FALSE(c.problem.reaction);
  CHECK_FALSE(c.problem.source);
  CHECK(c.problem.stabilize);
  CHECK(c.problem.boundary.size() == 4);
  CHECK_FALSE(with_problem(R"("stabilize": false, )" + kZeroBoundary).problem.stabilize);
  CHECK_FALSE(c.problem.correct_defect);
  CHECK(with_problem(R"("defect_correction": true, )" + kZeroBoundary).problem.correct_defect);
}

TEST_CASE("Coefficients per region follow the region's number", "[adapt][case]") {
  const std::string geometry =
      R"({"geometry": {"rectangle": {"min": [0, 0], "max": [2, 1]}, "regions": {"steel": [0.5, 0.5], "air": [1.5, 0.5]},
         "segments": [{"from": [1, 0], "to": [1, 1]}]}, "problem": {)";
  const auto parse = [&](const std::string& problem) { return parse_case(geometry + problem + "}}", "case.json"); };
  const Case c = parse(R"("diffusion": {"steel": 40, "*": [[1, 0], [0, 2]]}, "velocity": {"air": ["y", 0], "*": [0, 0]},
                          "source": {"steel": "x", "air": 3},)" +
                       kZeroBoundary);
  const int steel = c.domain.regions[0].region;
  const int air = c.domain.regions[1].region;
  CHECK(c.problem.diffusion({}, steel).yy == 40.0);
  CHECK(c.problem.diffusion({}, air).yy == 2.0);
  CHECK(c.problem.diffusion({}, 0).xx == 1.0);
  CHECK(c.problem.velocity({0.0, 5.0}, air).x == 5.0);
  CHECK(c.problem.source({7.0, 0.0}, steel) == 7.0);
  CHECK_THROWS_WITH(c.problem.source({}, 0), Catch::Contains("/problem/source: no value for region 0"));
  CHECK_THAT(issue_text(geometry + R"("diffusion": {"stel": 1, "*": 1}, )" + kZeroBoundary + "}}"),
             Catch::Contains("no region 'stel'; did you mean 'steel'"));
  CHECK_THAT(issue_text(geometry + R"("diffusion": {"steel": 1}, )" + kZeroBoundary + "}}"),
             Catch::Contains("/problem/diffusion: no value for the regions 'air'"));
}

TEST_CASE("A value that is not finite is refused where it is used, by name and place", "[adapt][case][errors]") {
  const Case c = with_problem(R"json("source": "1/(x - 0.5)", "reaction": "sqrt(y - 1)", )json" + kZeroBoundary);
  CHECK_THROWS_AS(c.problem.source({0.5, 0.25}, 0), ProblemError);
  CHECK_THROWS_WITH(c.problem.source({0.5, 0.25}, 0),
                    "/problem/source: the expression '1/(x - 0.5)' is inf at x = 0.5, y = 0.25");
  CHECK_THROWS_WITH(c.problem.reaction({0.0, 0.0}, 0), Catch::Contains("'sqrt(y - 1)' is nan at x = 0, y = 0"));
  const Case derived = with_problem(R"json("exact": "sqrt(x)", "boundary": {"*": {"dirichlet": "exact"}})json");
  CHECK_THROWS_WITH(derived.problem.source({0.0, 0.5}, 0),
                    Catch::StartsWith("/problem/exact: the source derived from the expression 'sqrt(x)' is "));
}

TEST_CASE("Boundary conditions must fit the sides", "[adapt][case][errors]") {
  CHECK(
      issue_text(case_text(R"("boundary": {"left": {"dirichlet": 0}, "right": {"neumann": 0}})")) ==
      "/problem/boundary: no condition for the sides 'bottom', 'top'; give one for each, or for \"*\" (all others)\n");
  CHECK_THAT(issue_text(case_text(R"("boundary": {"*": {"dirichlet": 0}, "lft": {"neumann": 0}})")),
             Catch::Contains("/problem/boundary/lft: the geometry has no side 'lft'; did you mean 'left'?"));
  CHECK_THAT(issue_text(case_text(R"("boundary": {"*": {"dirichlet": 0, "neumann": 0}})")),
             Catch::Contains("give exactly one of 'dirichlet', 'neumann', 'robin'; found 'dirichlet', 'neumann'"));
  CHECK_THAT(issue_text(case_text(R"("boundary": {"*": {"robin": {"value": 0}}})")),
             Catch::Contains("/problem/boundary/*/robin: the key 'coefficient' is missing"));
  CHECK_THAT(issue_text(case_text(R"("boundary": {"*": {"dirichlet": "exact"}})")),
             Catch::Contains("unknown name 'exact'"));
  CHECK_THAT(issue_text(case_text(R"("source": 1)")), Catch::Contains("/problem: the key 'boundary' is missing"));
}

TEST_CASE("A problem that cannot be read is refused with what is allowed", "[adapt][case][errors]") {
  CHECK_THAT(issue_text(case_text(R"("diffusion": [[1, "x"], ["y", 1]], )" + kZeroBoundary)),
             Catch::Contains("/problem/diffusion: the matrix must be symmetric"));
  CHECK_THAT(issue_text(case_text(R"("diffusion": true, )" + kZeroBoundary)),
             Catch::Contains("must be a number or an expression, or a matrix [[a, b], [b, c]], or an object"));
  CHECK_THAT(issue_text(case_text(R"("velocity": [1], )" + kZeroBoundary)), Catch::Contains("a list [a, b]"));
  CHECK_THAT(issue_text(case_text(R"("interpolate": "x", "diffusion": 1)")),
             Catch::Contains("unknown key 'diffusion'"));
  CHECK_THAT(issue_text(case_text(R"("interpolate": "x")", R"(, "initial": {"continuation": 10})")),
             Catch::Contains("/initial/continuation: is for the diffusion of a problem"));
  CHECK_THAT(issue_text(R"({"problem": {"interpolate": "x"}})"), Catch::Contains("the key 'geometry' is missing"));
  CHECK_THAT(issue_text(case_text(R"("source": "nx", )" + kZeroBoundary)), Catch::Contains("unknown name 'nx'"));
}

TEST_CASE("Defect correction is refused with what contradicts it", "[adapt][case][errors]") {
  const std::string corrected = R"("defect_correction": true, )";
  CHECK(issue_text(case_text(corrected + R"("discontinuity_capturing": true, )" + kZeroBoundary)) ==
        "/problem/defect_correction: takes back what 'discontinuity_capturing' adds; leave one of them out\n");
  CHECK(issue_text(case_text(corrected + kZeroBoundary,
                             R"(, "functionals": {"mean": {"integral": "*"}}, "targets": {"goal_error": 1e-3})")) ==
        "/targets/goal_error: corrects its own values by the dual solution: leave 'defect_correction' out of the "
        "problem\n");
}

TEST_CASE("The solver that a case names is the one the problem is solved by", "[adapt][case]") {
  CHECK(with_problem(kZeroBoundary).problem.solver.method == SolverMethod::Automatic);
  const std::string solver = R"(, "solver": {"method": "gmres", "preconditioner": "ilut", "restart": 20})";
  const SolverOptions options = with_problem(R"("velocity": [1, 0], )" + kZeroBoundary, solver).problem.solver;
  CHECK(options.method == SolverMethod::Gmres);
  CHECK(options.preconditioner == Preconditioner::IncompleteLu);
  CHECK(options.restart == 20);
}

TEST_CASE("A solver that does not suit the problem is refused", "[adapt][case][errors]") {
  const std::string flow = R"("velocity": [1, 0], )" + kZeroBoundary;
  CHECK_THAT(issue_text(case_text(flow, R"(, "solver": {"method": "cg"})")),
             Catch::Contains("/solver/method: 'cg' needs a symmetric matrix"));
  CHECK_THAT(issue_text(case_text(kZeroBoundary, R"(, "solver": {"method": "cg", "preconditioner": "ilut"})")),
             Catch::Contains("/solver/preconditioner: 'cg' needs a symmetric one"));
  CHECK_THAT(issue_text(case_text(flow, R"(, "solver": {"method": "gmers"})")), Catch::Contains("'gmres'"));
  CHECK_THAT(issue_text(case_text(flow, R"(, "solver": {"restart": 0})")), Catch::Contains("/solver/restart"));
}

TEST_CASE("A source or Dirichlet data that contradict the exact solution are found", "[adapt][case][errors]") {
  const std::string exact = R"json("exact": "sin(pi*x)*sin(pi*y)", )json";
  CHECK(issue_text(case_text(exact + R"json("source": "2*pi^2*sin(pi*x)*sin(pi*y)", )json" + kZeroBoundary)).empty());
  CHECK_THAT(issue_text(case_text(exact + R"json("source": "pi^2*sin(pi*x)*sin(pi*y)", )json" + kZeroBoundary)),
             Catch::Contains("/problem/source: does not agree with 'exact': at ("));
  CHECK_THAT(issue_text(case_text(exact + R"("boundary": {"*": {"dirichlet": 0}, "top": {"dirichlet": "0.1*x"}})")),
             Catch::Contains("the condition on 'top' does not agree with 'exact'"));
}

TEST_CASE("Fluxes and Robin data that contradict the exact solution are found, whichever way sides run",
          "[adapt][case][errors]") {
  const auto right = [](const std::string& condition) {
    return issue_text(case_text(R"("exact": "x^2 + y", "diffusion": [[3, 1], [1, 2]],
        "boundary": {"*": {"dirichlet": "exact"}, "right": )" +
                                condition + "}"));
  };
  CHECK(right(R"({"neumann": 7})").empty());  // 3 * 2 x + 1
  CHECK(right(R"({"neumann": "7*nx"})").empty());
  CHECK(right(R"({"neumann": "exact"})").empty());
  CHECK_THAT(right(R"({"neumann": 2})"),
             Catch::Contains("'right' does not agree") && Catch::Contains("n.K grad u = 7"));
  CHECK(right(R"({"robin": {"coefficient": 4, "value": "11 + 4*y"}})").empty());
  CHECK(right(R"({"robin": {"coefficient": 4, "value": "exact"}})").empty());
  CHECK_THAT(right(R"({"robin": {"coefficient": 4, "value": "4*exact"}})"), Catch::Contains("coefficient u = "));
}

TEST_CASE("A matrix may be as symmetric as rounding leaves it", "[adapt][case]") {
  const auto with = [](const std::string& entry) {
    return issue_text(case_text(R"("diffusion": [[1, 0.30000000000000004], [)" + entry + ", 1]], " + kZeroBoundary));
  };
  CHECK(with("0.3").empty());
  CHECK_THAT(with("0.3000001"), Catch::Contains("must be symmetric"));
}

TEST_CASE("No side and no region is called *", "[adapt][case][errors]") {
  const auto with = [](const std::string& more) {
    return issue_text(R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}, )" + more +
                      R"(}, "problem": {"interpolate": "x"}})");
  };
  CHECK_THAT(with(R"("labels": {"left": "*"})"), Catch::Contains("/geometry: a side may not be called \"*\""));
  CHECK_THAT(with(R"("regions": {"*": [0.5, 0.5]})"), Catch::Contains("/geometry: a region may not be"));
}

TEST_CASE("Dirichlet data that know the normal are held against the exact solution with it", "[adapt][case][errors]") {
  // On the unit circle nx = x.
  const auto on_disc = [](const std::string& data) {
    return issue_text(
        R"({"geometry": {"disc": {"radius": 1}}, "problem": {"exact": "x", "boundary": {"*": {"dirichlet": ")" + data +
        R"("}}}})");
  };
  CHECK(on_disc("nx").empty());
  CHECK(on_disc("nx^2 + ny^2 - 1 + x").empty());
  CHECK_THAT(on_disc("ny"), Catch::Contains("does not agree with 'exact'"));
  CHECK_THAT(on_disc("1.1*nx"), Catch::Contains("does not agree with 'exact'"));
}

TEST_CASE("A coefficient per region that has notes only is refused", "[adapt][case][errors]") {
  const std::string key = GENERATE("source", "diffusion", "velocity", "reaction");
  const std::string notes = "\"" + key + R"(": {"x-note": 1}, )";
  CHECK_THAT(issue_text(case_text(R"("exact": "x", )" + notes + kZeroBoundary)),
             Catch::Contains("/problem/" + key + ": no value"));
}

}  // namespace parmesan
