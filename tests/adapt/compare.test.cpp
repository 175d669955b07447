#include "adapt/compare.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <filesystem>

#include "mesher/errors.h"
#include "tests/adapt/loop_cases.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;

namespace {

CompareResult small_comparison(const support::TemporaryFolder& folder, std::vector<std::string>& lines) {
  CompareOptions options;
  options.out_dir = folder.path();
  options.sizes = {200, 800};
  options.max_uniform_vertices = 20000;
  options.progress = [&lines](const Progress& progress) { lines.push_back(progress.line); };
  return compare_case(support::interpolation_case("tanh(20*(x - y^2))", "{}"), options);
}

}  // namespace

TEST_CASE("compare_case ranks anisotropic before isotropic before uniform meshes", "[adapt][compare]") {
  const support::TemporaryFolder folder;
  std::vector<std::string> lines;
  const CompareResult result = small_comparison(folder, lines);
  const auto error_of = [&result](MeshFamily family) {
    double l2 = 0.0;
    for (const CompareRow& row : result.rows)
      if (row.family == family && row.vertices < 1000) l2 = row.leading_l2();
    return l2;
  };
  CHECK(error_of(MeshFamily::Anisotropic) < 0.7 * error_of(MeshFamily::Isotropic));
  CHECK(error_of(MeshFamily::Isotropic) < 0.7 * error_of(MeshFamily::Uniform));
  REQUIRE(result.l2_orders.size() == 3);
  CHECK(result.l2_orders[0].order > 0.8);
  CHECK(lines.size() == result.rows.size());

  SECTION("each adapted mesh has its uniform equivalent, which is larger") {
    CHECK(result.equivalents.size() == 4);
    int interpolated = 0;
    for (const UniformEquivalent& e : result.equivalents) {
      CHECK(e.uniform.found != EqualError::Found::BelowSmallest);
      CHECK(e.uniform.size > static_cast<double>(e.vertices));  // of one that is not reached, the largest there was
      interpolated += e.uniform.found == EqualError::Found::Interpolated ? 1 : 0;
    }
    CHECK(interpolated >= 3);
  }
  SECTION("files and table have all rows") {
    CHECK(folder.has("compare.csv"));
    CHECK(folder.has("summary.json"));
    const std::string csv = compare_csv(result);
    CHECK(static_cast<std::size_t>(std::ranges::count(csv, '\n')) == result.rows.size() + 1);
    CHECK(to_json(result)["rows"].size() == result.rows.size());
    CHECK(result.table.find("anisotropic") != std::string::npos);
  }
}

TEST_CASE("no order is fitted to errors that are round-off, and the table says why", "[adapt][compare]") {
  const support::TemporaryFolder folder;
  CompareOptions options;
  options.out_dir = folder.path();
  options.sizes = {100, 200};
  const CompareResult result = compare_case(support::interpolation_case("1 + x - 3*y", "{}"), options);
  REQUIRE(result.l2_orders.size() == 3);
  for (const OrderFit& fit : result.l2_orders) CHECK(fit.num_points == 0);
  CHECK(result.table.find("errors are round-off") != std::string::npos);
  CHECK(to_json(result)["orders"]["uniform"]["l2"].is_null());
}

TEST_CASE("refined uniform meshes of a curved domain keep to its curves", "[adapt][compare][curves]") {
  // On chords, where 1 - r^2 is not 0, the error of the given values would stay as it was.
  const support::TemporaryFolder folder;
  CompareOptions options;
  options.out_dir = folder.path();
  options.sizes = {200, 1000};
  options.max_uniform_vertices = 20000;
  const Case input = parse_case(R"case({"geometry": {"disc": {"radius": 1}}, "problem": {
      "exact": "(1 - x^2 - y^2)*(1 + tanh(20*x))", "boundary": {"*": {"dirichlet": 0}}}, "initial": {"vertices": 100},
      "mesher": {"preset": "fast"}})case",
                                "case.json");
  std::vector<double> errors;
  for (const CompareRow& row : compare_case(input, options).rows)
    if (row.family == MeshFamily::Uniform) errors.push_back(row.leading_l2());
  REQUIRE(errors.size() > 3);
  CHECK(errors[errors.size() - 2] / errors.back() == Approx(4.0).margin(0.3));  // of order h^2
}

TEST_CASE("compare_case refuses sizes that do not ascend", "[adapt][compare][errors]") {
  CompareOptions options;
  options.out_dir = support::TemporaryFolder().path();
  options.sizes =
      GENERATE(std::vector<std::int64_t>{}, std::vector<std::int64_t>{400, 400}, std::vector<std::int64_t>{2, 400});
  CHECK_THROWS_AS(compare_case(support::interpolation_case("x*x", "{}"), options), InputError);
}

TEST_CASE("a comparison that failed leaves its folder to the next", "[adapt][compare][errors]") {
  const support::TemporaryFolder folder;
  CompareOptions options;
  options.out_dir = folder.path();
  options.sizes = {200, 400};
  CHECK_THROWS_AS(compare_case(support::interpolation_case("log(x - 2)", R"({"vertices": 200})"), options), InputError);
  CHECK_FALSE(folder.has("case.json"));
  CHECK_NOTHROW(compare_case(support::interpolation_case("log(x + 2)", R"({"vertices": 200})"), options));
  CHECK(folder.has("case.json"));
}

TEST_CASE("a comparison keeps within the safety limit", "[adapt][compare][errors]") {
  const support::TemporaryFolder folder;
  const Case input = support::interpolation_case("tanh(20*(x - y^2))", "{}");
  CompareOptions options;
  options.out_dir = folder.path();
  options.sizes = {100, 300};
  options.max_vertices = 200;
  CHECK_THROWS_AS(compare_case(input, options), LimitError);
  options.max_vertices = 700;  // four times 300 would come nearer to the errors of the adapted meshes
  const CompareResult result = compare_case(input, options);
  CHECK(result.rows.size() == 6);
  for (const CompareRow& row : result.rows) CHECK(row.vertices <= 700);
}

TEST_CASE("an interrupted comparison replaces nothing while it has no mesh, and says that it was", "[adapt][compare]") {
  const support::TemporaryFolder folder;
  const Case input = support::interpolation_case("tanh(20*(x - y^2))", "{}");
  CompareOptions options;
  options.out_dir = folder.path();
  options.sizes = {100};
  options.max_uniform_vertices = 400;
  compare_case(input, options);
  const auto before = std::filesystem::last_write_time(folder / "summary.json");
  std::atomic<bool> stop{true};
  options.interrupted = &stop;
  options.overwrite = true;
  const CompareResult none = compare_case(input, options);
  CHECK(none.interrupted);
  CHECK(none.out_dir.empty());
  for (const char* name : {"case.json", "compare.csv", "report.html"}) CHECK(folder.has(name));
  REQUIRE(folder.has("summary.json"));
  CHECK(std::filesystem::last_write_time(folder / "summary.json") == before);
  stop = false;
  options.progress = [&stop](const Progress&) { stop = true; };
  const CompareResult some = compare_case(input, options);
  CHECK(some.rows.size() == 1);
  CHECK_THAT(some.table, Catch::Contains("interrupted"));
  CHECK(some.out_dir == folder.path());
}
