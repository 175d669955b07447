#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "mesher/io/mesh_file.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/box.h"
#include "tests/support/corpus.h"
#include "tests/support/meshes.h"
#include "tests/support/shared.h"
#include "tests/system/program.h"

using namespace parmesan;
using support::CorpusEntry;
using support::ProgramResult;
using support::run_other;
using support::TemporaryFolder;

namespace {

constexpr int geometry_invalid = 4;

/// `parmesan mesh` with 2 GB of memory and 60 seconds.
ProgramResult run_limited(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"-c", R"(ulimit -v 2000000; exec timeout 60 "$0" mesh "$@")", PARMESAN_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_other("bash", words, folder.path());
}

std::string decimal(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// The domain as a file that the program reads by the even-odd rule.
void write_geometry(const std::string& path, const Domain& domain) {
  Mesh mesh;
  mesh.points = domain.points;
  for (const Segment& s : domain.segments) {
    mesh.edges.push_back({s.a, s.b});
    mesh.labels.push_back(s.label);
  }
  write_mesh_file(path, mesh);
}

/// A grid over the box whose vertices carry the metric of a layer.
void write_background(const TemporaryFolder& folder, const support::Box& box) {
  constexpr int cells = 60;
  const double margin = 0.01 * box.diameter();
  const Mesh grid = support::rectangle_mesh(cells, cells, {box.low.x - margin, box.low.y - margin},
                                            {box.high.x + margin, box.high.y + margin});
  const auto layer = support::layer_in(box);
  std::vector<Metric> metrics;
  for (const Point& p : grid.points) metrics.push_back(layer.at(p));
  write_mesh_file(folder / "box.mesh", grid, {{tensor_field("metric", metrics)}, {}});
}

/// A few of each kind, small and large; all of them where the environment asks for the whole corpus.
std::vector<CorpusEntry> chosen(const std::string& corpus) {
  std::vector<CorpusEntry> entries = support::corpus_entries(corpus);
  std::erase_if(entries, [](const CorpusEntry& e) { return e.kind != "invalid-crossing" && e.triangles == 0; });
  if (std::getenv("PARMESAN_WHOLE_CORPUS") != nullptr) return entries;
  std::ranges::stable_sort(entries, {}, [](const CorpusEntry& e) { return std::pair(e.kind, e.segments); });
  std::vector<CorpusEntry> some;
  for (std::size_t i = 0; i < entries.size(); i += 12) some.push_back(entries[i]);
  some.push_back(entries.back());
  return some;
}

void check_output(const TemporaryFolder& folder, const CorpusEntry& entry, const support::Box& box) {
  const Mesh mesh = read_mesh_file(folder / "out.mesh");
  for (const std::string& problem : oracle::problems_of(mesh)) FAIL_CHECK(problem);
  const double rounding = 1e-15 * box.diameter() * box.largest();  // vertices on slanted segments
  CHECK(std::abs(oracle::area_of(mesh) - entry.area) < 1e-5 * entry.area + rounding);
}

}  // namespace

TEST_CASE("the program meshes the corpus at three sizes within 2 GB and a minute each, or says what is wrong",
          "[system][shared][slow]") {
  const auto shared = support::shared_dir();
  if (!shared) return;
  for (const CorpusEntry& entry : chosen(*shared + "/corpus")) {
    INFO(entry.file);
    const Domain domain = support::read_corpus_file(*shared + "/corpus/" + entry.file);
    const support::Box box = support::box_of(domain.points);
    const TemporaryFolder folder;
    write_geometry(folder / "in.mesh", domain);
    write_background(folder, box);
    const std::array<std::vector<std::string>, 3> sizes{
        std::vector<std::string>{"--size", decimal(0.3 * box.diameter())},
        {"--size", decimal(0.05 * box.diameter())},
        {"--background", "box.mesh", "--metric", "box.sol"}};
    for (std::vector<std::string> arguments : sizes) {
      INFO(arguments[0] << " " << arguments[1]);
      arguments.insert(arguments.begin(), {"in.mesh", "-o", "out.mesh", "-q"});
      const ProgramResult result = run_limited(folder, arguments);
      INFO(result.err);
      if (entry.kind == "invalid-crossing") {
        CHECK(result.exit_code == geometry_invalid);
        CHECK_THAT(result.err, Catch::Contains("cross"));
        continue;
      }
      REQUIRE(result.exit_code == 0);
      check_output(folder, entry, box);
    }
  }
}
