#include "adapt/given_field.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "adapt/adapt_loop.h"
#include "fem/norms.h"
#include "loop_cases.h"
#include "mesher/io/medit.h"
#include "mesher/io/medit_fields.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;

namespace {

double layer(const Point& p) { return std::tanh(10.0 * (p.x - p.y * p.y)); }

/// A folder with a mesh and the values of a function on it, and the case that names them.
class GivenCase {
 public:
  explicit GivenCase(const Mesh& mesh) {
    write_medit(folder_ / "u.mesh", mesh);
    write_medit_fields(folder_ / "u.sol", {{{"u", 1, interpolate(mesh, layer)}}, {}});
  }

  const support::TemporaryFolder& folder() const { return folder_; }

  Case read(const std::string& interpolate, const std::string& rest = "") const {
    return parse_case(R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}, "problem": {"interpolate": )" +
                          interpolate + R"(}, "mesher": {"preset": "fast"}, "initial": {"vertices": 100})" + rest + "}",
                      folder_ / "case.json");
  }

 private:
  support::TemporaryFolder folder_;
};

const std::string files = R"({"file": "u.sol", "mesh": "u.mesh"})";

}  // namespace

TEST_CASE("function_of is the P1 function with the values at the vertices", "[adapt][given]") {
  const auto field = std::make_shared<GivenField>();
  field->mesh = support::random_square(7, 0.2, 1);
  field->values = interpolate(field->mesh, [](const Point& p) { return 1.0 + 2.0 * p.x - 3.0 * p.y; });
  field->values[20] += 0.1;
  const ExactFunction f = function_of(field);
  for (std::size_t v = 0; v < field->values.size(); ++v)
    CHECK(f.value(field->mesh.points[v]) == Approx(field->values[v]).margin(1e-12));
  const Vector far = f.gradient({0.9, 0.1});
  CHECK(far.x == Approx(2.0).epsilon(1e-9));
  CHECK(far.y == Approx(-3.0).epsilon(1e-9));
  CHECK(f.value({-1e-9, 0.5}) == Approx(f.value({0.0, 0.5})).epsilon(1e-6));  // outside: a place nearby
}

TEST_CASE("a domain that reaches beyond the mesh of its function is warned of", "[adapt][given][loop]") {
  const auto warnings = [](double width) {
    Mesh mesh = support::rectangle_mesh(8, 8);
    for (Point& p : mesh.points) p.x *= width;
    const GivenCase data(mesh);
    return adapt(data.read(files, R"(, "targets": {"vertices": 100, "max_iterations": 1})"), {}).summary.warnings;
  };
  const auto says = [](const std::string& text) { return text.find("reaches beyond") != std::string::npos; };
  const std::vector<std::string> short_of = warnings(0.75);
  const auto found = std::ranges::find_if(short_of, says);
  REQUIRE(found != short_of.end());
  CHECK_THAT(*found, Catch::Contains("by about 0.2"));
  CHECK(std::ranges::none_of(warnings(1.0), says));
  CHECK(std::ranges::none_of(warnings(1.5), says));
}

TEST_CASE("a mesh is adapted to a function from a file as to its expression", "[adapt][given][loop][slow]") {
  const GivenCase data(support::rectangle_mesh(160, 160));
  const Case given = data.read(files, R"(, "targets": {"vertices": 400, "max_iterations": 8})");
  REQUIRE(given.given);
  const LoopResult run = adapt(given, {});
  const LoopResult known = adapt(support::interpolation_case("tanh(10*(x - y^2))", R"({"vertices": 400})"), {});
  const double error = error_norms(run.last.mesh, interpolate(run.last.mesh, layer), {layer, nullptr}).l2;
  CHECK(error < 1.35 * known.summary.iterations.back().interpolation_error->l2);
  // Measured against the data, not against what they stand for: the data's own error is below 1/10 of it.
  CHECK(run.summary.iterations.back().interpolation_error->l2 == Approx(error).epsilon(0.15));
}

TEST_CASE("a domain that is a part of a field's mesh gets the size asked for, too", "[adapt][given][loop]") {
  const GivenCase data(support::rectangle_mesh(40, 40));
  const std::string box = GENERATE(as<std::string>{}, R"({"min": [0.2, 0.2], "max": [0.8, 0.9]})",
                                   R"({"min": [0.5, 0.6], "max": [0.6, 0.7]})");
  const Case part = parse_case(R"({"geometry": {"rectangle": )" + box + R"(}, "problem": {"interpolate": )" + files +
                                   R"(}, "mesher": {"preset": "fast"}, "initial": {"vertices": 100},
                                  "targets": {"vertices": 400}})",
                               data.folder() / "case.json");
  const LoopResult run = adapt(part, {});
  CHECK(run.summary.stop_reason == StopReason::Vertices);
  CHECK(run.last.mesh.num_vertices() == Approx(400).epsilon(0.03));
  for (const std::string& warning : run.summary.warnings) CHECK(warning.find("cannot be told") == std::string::npos);
}

TEST_CASE("fields in a mesh file are found by their names", "[adapt][given][case]") {
  const GivenCase data(support::rectangle_mesh(3, 3));
  std::string rows;
  for (int i = 0; i < 16; ++i) rows += "1 " + std::to_string(i) + "\n";
  data.folder().write("two.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices 16\n2 1 1\n" + rows + "End\n");
  const std::string two = R"({"file": "two.sol", "mesh": "u.mesh")";
  CHECK_THROWS_WITH(data.read(two + "}"), Catch::Contains("/problem/interpolate/field: must name one of several"));
  CHECK_THROWS_WITH(data.read(two + R"(, "field": "nothing"})"), Catch::Contains("there is no field 'nothing'"));
  CHECK(data.read(two + R"(, "field": "two_2"})").given->values[15] == 15.0);
}

TEST_CASE("data that cannot be used are refused with the reason", "[adapt][given][case][errors]") {
  const GivenCase data(support::rectangle_mesh(3, 3));
  CHECK_THROWS_WITH(data.read(R"({"file": "v.sol", "mesh": "u.mesh"})"),
                    Catch::Contains("/problem/interpolate/file: cannot read 'v.sol': there is no such file"));
  CHECK_THROWS_WITH(data.read(R"({"file": "u.sol", "mesh": "../u.mesh"})"),
                    Catch::Contains("/problem/interpolate/mesh: must name a file beside or below"));
  CHECK_THROWS_WITH(data.read(R"({"file": "u.sol"})"), Catch::Contains("the key 'mesh' is missing"));
  CHECK_THROWS_WITH(data.read(R"({"file": "u.sol", "mesh": "u.mesh", "fiel": "u"})"), Catch::Contains("unknown key"));
  write_medit(data.folder() / "large.mesh", support::rectangle_mesh(4, 4));
  CHECK_THROWS_WITH(data.read(R"({"file": "u.sol", "mesh": "large.mesh"})"),
                    Catch::Contains("has 16 values; the mesh has 25 vertices"));
  CHECK_THROWS_WITH(data.read(files, R"(, "metric": {"recovery": "exact"})"),
                    Catch::Contains("needs the exact solution"));
}
