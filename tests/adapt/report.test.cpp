#include "adapt/report/report.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>

#include "adapt/checkpoint.h"
#include "adapt/run_case.h"
#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "tests/adapt/loop_cases.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;
using support::content_of;
using support::TemporaryFolder;

namespace {

const std::string hostile = "</script><script>alert(1)</script><!--";

Case hostile_case() {
  Case input = support::poisson_case("sin(3*x)*y^2", R"({"vertices": 200})");
  input.title = hostile;
  input.resolved["title"] = hostile;
  return input;
}

RunResult run_into(const TemporaryFolder& folder) {
  RunOptions options;
  options.out_dir = folder.path();
  return run_case(hostile_case(), options);
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t number = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++number;
  return number;
}

// What stands in the script element with this id.
std::string script(const std::string& page, const std::string& id) {
  const std::size_t begin = page.find('>', page.find("id=\"" + id + "\"")) + 1;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

std::string decoded(const std::string& base64) {
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int num_bits = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(alphabet.find(c));
    num_bits += 6;
    if (num_bits < 8) continue;
    num_bits -= 8;
    bytes += static_cast<char>(bits >> num_bits & 255u);
  }
  return bytes;
}

}  // namespace

TEST_CASE("the report of a run has its summary and its mesh, and loads nothing", "[adapt][report]") {
  const TemporaryFolder folder;
  run_into(folder);
  const std::string page = content_of(folder / "report.html");
  const auto data = nlohmann::json::parse(script(page, "data"));
  REQUIRE(data["entries"].size() == 1);
  CHECK(data["entries"][0]["summary"] == nlohmann::json::parse(content_of(folder / "summary.json")));
  CHECK(data["entries"][0]["case"]["title"] == hostile);
  const Mesh mesh = read_medit(folder / "mesh.mesh");
  const std::string points = decoded(script(page, "array-0-points"));
  REQUIRE(points.size() == mesh.points.size() * 2 * sizeof(double));
  std::vector<Point> drawn(mesh.points.size());
  std::memcpy(drawn.data(), points.data(), points.size());
  CHECK(drawn == mesh.points);
  CHECK(decoded(script(page, "array-0-error")).size() == mesh.triangles.size() * sizeof(double));
  for (const char* loading : {"src=\"http", "href=\"http", "url(", "import ", "fetch(", "<link"})
    CHECK(count(page, loading) == 0);
}

TEST_CASE("the report carries values as they are, also those that differ in their last digits only or are very small",
          "[adapt][report]") {
  const TemporaryFolder folder;
  RunOptions options;
  options.out_dir = folder.path();
  const std::string function = GENERATE("300 + 1e-6*sin(3*x)*y^2", "1e-50*sin(3*x)*y^2", "1e50*sin(3*x)*y^2");
  run_case(support::interpolation_case(function, R"({"vertices": 200, "max_iterations": 1})"), options);
  const std::vector<double> values = find_checkpoint(folder.path()).checkpoint.value().state.last.values;
  const std::string carried = decoded(script(content_of(folder / "report.html"), "array-0-solution"));
  REQUIRE(carried.size() == values.size() * sizeof(double));
  CHECK(std::memcmp(carried.data(), values.data(), carried.size()) == 0);
}

TEST_CASE("no name in a case can end or begin an element of the report", "[adapt][report]") {
  const TemporaryFolder folder;
  run_into(folder);
  const std::string page = content_of(folder / "report.html");
  CHECK(count(page, "alert(1)") > 0);  // it is there, as text
  CHECK(count(page, "<script>alert") == 0);
  CHECK(count(page, "<!--") == 0);
  CHECK(count(page, "<script") == count(page, "</script>"));
}

TEST_CASE("histograms count every edge, angle and triangle", "[adapt][report]") {
  const TemporaryFolder folder;
  const RunResult run = run_into(folder);
  const auto data = nlohmann::json::parse(script(content_of(folder / "report.html"), "data"));
  const auto total = [&](const char* name) {
    long sum = 0;
    for (const long n : data["entries"][0]["histograms"][name]["counts"]) sum += n;
    return sum;
  };
  const IterationRow& last = run.summary.iterations.back();
  CHECK(total("qualities") == last.triangles);
  CHECK(total("angles") == 3 * last.triangles);
  CHECK(total("lengths") == last.vertices + last.triangles - 1);  // Euler, a domain without holes
}

TEST_CASE("a report that is written again is the same, and several runs go into one page", "[adapt][report]") {
  const TemporaryFolder folder;
  run_into(folder);
  write_report(folder / "again.html", {folder.path()});
  CHECK(content_of(folder / "again.html") == content_of(folder / "report.html"));
  write_report(folder / "two.html", {folder.path(), folder.path()});
  const std::string two = content_of(folder / "two.html");
  CHECK(nlohmann::json::parse(script(two, "data"))["entries"].size() == 2);
  CHECK(script(two, "array-1-points") == script(two, "array-0-points"));
}

TEST_CASE("a report needs a finished run whose files are what we wrote", "[adapt][report][errors]") {
  const TemporaryFolder folder;
  run_into(folder);
  const std::string out = folder / "page.html";
  SECTION("no such folder") { CHECK_THROWS_AS(write_report(out, {folder / "nothing"}), FileError); }
  SECTION("not finished") {
    std::filesystem::remove(folder / "summary.json");
    CHECK_THROWS_WITH(write_report(out, {folder.path()}), Catch::Contains("summary.json"));
  }
  SECTION("not JSON") {
    folder.write("case.json", "{");
    CHECK_THROWS_AS(write_report(out, {folder.path()}), FileError);
  }
  SECTION("nested a hundred thousand deep") {
    folder.write("case.json", "{\"a\":" + std::string(100000, '[') + std::string(100000, ']') + "}");
    CHECK_THROWS_AS(write_report(out, {folder.path()}), FileError);
  }
  SECTION("fields of other types than ours") {
    folder.write("case.json", R"({"problem": 3, "parameters": [1]})");
    CHECK_THROWS_AS(write_report(out, {folder.path()}), FileError);
  }
  CHECK_FALSE(folder.has("page.html"));
}

TEST_CASE("where both checkpoints are damaged the report does without a mesh", "[adapt][report]") {
  const TemporaryFolder folder;
  run_into(folder);
  std::filesystem::remove_all(folder / "checkpoint");
  write_report(folder / "report.html", {folder.path()});
  CHECK(content_of(folder / "report.html").find("array-0-points") == std::string::npos);
}
