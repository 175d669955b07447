#include <catch2/catch.hpp>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "tests/mesher/io/error_line.h"
#include "tests/support/temporary_folder.h"

using parmesan::FileError;
using parmesan::Metric;
using parmesan::parse_medit_metric;
using parmesan::SymmetricTensor;
using parmesan::support::error_line;
using parmesan::support::TemporaryFolder;

namespace {

const std::string metric_head = "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n";

std::vector<Metric> parse_metric(const std::string& text) { return parse_medit_metric(text, "t.sol"); }
int metric_line_of(const std::string& text) {
  return error_line([&text] { parse_medit_metric(text, "t.sol", 2); });
}

}  // namespace

TEST_CASE("Metrics come back from a .sol file bit by bit", "[mesher][io][medit]") {
  const TemporaryFolder folder;
  std::vector<Metric> metrics;
  for (int i = 0; i < 50; ++i) metrics.push_back(Metric::from_sizes(1.0 / (1 + 7 * i), 0.3 + i, 0.37 * i));
  parmesan::write_medit_metric(folder / "m.sol", metrics);
  const std::vector<Metric> back = parmesan::read_medit_metric(folder / "m.sol", 50);
  REQUIRE(back.size() == metrics.size());
  for (std::size_t i = 0; i < back.size(); ++i) CHECK(back[i].tensor() == metrics[i].tensor());
}

TEST_CASE("A .sol file gives tensors in the order m11 m12 m22, or sizes", "[mesher][io][medit]") {
  const std::vector<Metric> tensors = parse_metric(metric_head + "2\n1 3\n4 1 9\n1 0 1\nEnd\n");
  REQUIRE(tensors.size() == 2);
  CHECK(tensors[0].tensor() == SymmetricTensor{4.0, 1.0, 9.0});
  CHECK(tensors[1].tensor() == SymmetricTensor{1.0, 0.0, 1.0});
  // A size of 1/4 is met by 16 I.
  const std::vector<Metric> sizes =
      parse_metric("MeshVersionFormatted\n2\n\nDimension 3\n\nSolAtVertices\n1\n1 1\n\n0.25\nEnd\n");
  REQUIRE(sizes.size() == 1);
  CHECK(sizes[0].tensor() == SymmetricTensor{16.0, 0.0, 16.0});
}

TEST_CASE("Every fault in a .sol file is refused with its line", "[mesher][io][medit][errors]") {
  CHECK(metric_line_of(metric_head + "2\n1 3\n1 0 1\n1 2 1\nEnd\n") == 7);    // det < 0
  CHECK(metric_line_of(metric_head + "2\n1 3\n1 0 1\n-1 0 -1\nEnd\n") == 7);  // negative definite
  CHECK(metric_line_of(metric_head + "2\n1 3\n0 0 0\n1 0 1\nEnd\n") == 6);    // semidefinite
  CHECK(metric_line_of(metric_head + "2\n1 1\n1\n0\nEnd\n") == 7);
  CHECK(metric_line_of(metric_head + "2\n1 1\n1\n-2\nEnd\n") == 7);
  CHECK(metric_line_of(metric_head + "2\n1 1\n1\nnan\nEnd\n") == 7);
  CHECK(metric_line_of(metric_head + "3\n1 1\n1\n1\n1\nEnd\n") == 4);  // 2 were expected
  CHECK(metric_line_of(metric_head + "2\n2 1 1\n1 1\n1 1\nEnd\n") == 5);
  CHECK(metric_line_of(metric_head + "2\n1 2\n1 1\n1 1\nEnd\n") == 5);
  CHECK(metric_line_of(metric_head + "2\n1 3\n1 0 1\n1 0 1\n1 0 1\nEnd\n") == 8);
  CHECK(metric_line_of("MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n2\n1 3\n1 0 1 0 0 1\n1 0 1 0 0 1\nEnd\n") ==
        5);
  CHECK(metric_line_of("MeshVersionFormatted 2\nDimension 2\nEnd\n") == 3);
  CHECK(metric_line_of("not this\n") == 1);
}

TEST_CASE("A .sol file that is cut off anywhere is refused", "[mesher][io][medit][errors]") {
  const std::string text = metric_head + "2\n1 3\n1.5 0 1\n10 0.25 1\nEnd";
  REQUIRE(parse_metric(text).size() == 2);
  for (std::size_t length = 0; length < text.size(); ++length) {
    CAPTURE(length);
    CHECK_THROWS_AS(parse_metric(text.substr(0, length)), FileError);
  }
}

TEST_CASE("Tensors of any sign are read from a .sol file, and nothing else", "[mesher][io][medit]") {
  const TemporaryFolder folder;
  const auto written = [&folder](const std::string& text) {
    folder.write("h.sol", text);
    return folder / "h.sol";
  };
  const std::vector<SymmetricTensor> tensors =
      parmesan::read_medit_tensor(written(metric_head + "3\n1 3\n-4 1 9\n0 0 0\n-1 0 -2\nEnd\n"), 3);
  CHECK(tensors == std::vector<SymmetricTensor>{{-4.0, 1.0, 9.0}, {0.0, 0.0, 0.0}, {-1.0, 0.0, -2.0}});
  const auto line = [&](const std::string& text) {
    const std::string path = written(text);
    return error_line([&path] { parmesan::read_medit_tensor(path, 2); });
  };
  CHECK(line(metric_head + "2\n1 1\n1\n1\nEnd\n") == 5);
  CHECK(line(metric_head + "1\n1 3\n1 0 1\nEnd\n") == 4);
  CHECK(line(metric_head + "2\n1 3\n1 0 1\n1 nan 1\nEnd\n") == 7);
}
