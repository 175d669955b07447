#include "adapt/measure.h"

#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "adapt/functional_value.h"
#include "tests/support/meshes.h"

using namespace parmesan;

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
