#include "adapt/convergence_csv.h"

#include <catch2/catch.hpp>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace parmesan;

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

// The lines below the first, by the names that stand there.
std::vector<std::map<std::string, std::string>> rows_of(const std::string& csv) {
  std::istringstream text(csv);
  std::string line;
  std::getline(text, line);
  const std::vector<std::string> names = cells_of(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(text, line)) {
    const std::vector<std::string> cells = cells_of(line);
    REQUIRE(cells.size() == names.size());
    for (std::size_t k = 0; k < names.size(); ++k)
      rows.resize(rows.size() + (k == 0)), rows.back()[names[k]] = cells[k];
  }
  return rows;
}

}  // namespace

TEST_CASE("convergence.csv has a line per iteration, numbers that read back to the bit, and holes for what is absent",
          "[adapt][summary]") {
  Summary summary;
  IterationRow row;
  row.vertices = 3'000'000'000;  // more than an int holds
  row.complexity = 0.1 + 0.2;
  row.interpolation_error = ErrorNorms{1.0, 1e-300, 2.0, std::numeric_limits<double>::infinity()};
  summary.iterations = {row, row};
  summary.iterations[1].iteration = 1;
  const auto rows = rows_of(convergence_csv(summary));
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].at("iteration") == "0");
  CHECK(rows[1].at("iteration") == "1");
  CHECK(rows[0].at("vertices") == "3000000000");
  CHECK(std::stod(rows[0].at("complexity")) == row.complexity);
  CHECK(std::stod(rows[0].at("interpolation_l2")) == 1e-300);
  for (const char* absent : {"interpolation_h1", "solution_l2", "goal_value", "efficiency"})
    CHECK(rows[0].at(absent).empty());
}
