#include "adapt/measure.h"

#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "adapt/functional_value.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

/// The goal on a uniform mesh of a square with a crack from its middle to the right, with this problem.
GoalRow goal_on_crack(const std::string& data, const std::string& functional, double vertices) {
  const Case input = parse_case(R"({"geometry": {"rectangle": {"min": [-1, -1], "max": [1, 1]},
      "segments": [{"from": [0, 0], "to": [1, 0], "label": "above", "label_right": "below"}]},
      "problem": {)" + data + R"(},
      "functionals": {"goal": )" + functional +
                                    R"(}, "targets": {"goal": "goal"}})",
                                "test.json");
  Iterate iterate = uniform_iterate(input, vertices);
  compute_values(input, iterate, nullptr);
  return measure(input, iterate, 0, std::nullopt).goal.value();
}

}  // namespace

TEST_CASE("targeted_error is the solution's where known, else the estimate, else the interpolant's", "[adapt][loop]") {
  Case input;
  IterationRow row;
  row.estimated_error = EstimatedError{0.1, 0.2, 0.7};
  CHECK(targeted_error(input, row).l2 == 0.1);
  CHECK(targeted_error(input, row).linf == 0.7);
  row.solution_error = ErrorNorms{0, 0.3, 0, 0};
  CHECK(targeted_error(input, row).l2 == 0.3);
  input.interpolation = true;
  row.interpolation_error = ErrorNorms{0, 0.4, 0, 0};
  CHECK(targeted_error(input, row).l2 == 0.4);
}

TEST_CASE("a goal's estimate falls with the mesh where data jump across a crack", "[adapt][goal]") {
  const auto magnitude = [](double vertices) {
    const std::string data = R"case("source": 0, "boundary": {"*": {"dirichlet": "atan2(-y, -x)"}})case";
    return goal_on_crack(data, R"({"integral": "*"})", vertices).estimate.magnitude;
  };
  CHECK(magnitude(1600) < 0.7 * magnitude(100));
}

TEST_CASE("the exact flux through a crack is that through both of its sides", "[adapt][goal]") {
  // sqrt(r) sin(theta/2): 1/(2 sqrt(r)) into the crack from above and from below, 1 each.
  const std::string data =
      R"case("exact": "sqrt(hypot(x, y))*cos(atan2(-y, -x)/2)", "boundary": {"*": {"dirichlet": "exact"}})case";
  for (const std::string side : {"above", "below"}) {
    const GoalRow goal = goal_on_crack(data, R"({"flux": ")" + side + R"("})", 100);
    CHECK(goal.value + goal.error.value() == Approx(-1.0).epsilon(0.02));
  }
}

TEST_CASE("the flux into an inner line without a condition is refused, not 0", "[adapt][goal][errors]") {
  Mesh mesh = support::rectangle_mesh(2, 2);
  mesh.edges.push_back({1, 4});
  mesh.labels.push_back(9);
  CaseFunctional flux;
  flux.name = "into";
  flux.kind = CaseFunctional::Kind::Flux;
  flux.where = "9";
  const std::vector<double> values(9, 0.0);
  const std::map<int, double> fluxes{{support::Top, 2.0}, {support::Left, 1.0}};
  CHECK_THROWS_WITH(evaluate(flux, mesh, values, fluxes), Catch::Contains("/functionals/into/flux: the side '9' lies"));
  flux.where = "*";
  CHECK(evaluate(flux, mesh, values, fluxes) == 3.0);
}
