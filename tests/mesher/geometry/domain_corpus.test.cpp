#include <array>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "mesher/geometry/domain.h"
#include "tests/support/shared.h"

using namespace parmesan;

namespace {

/// One row of the exact classification, made by another library, of the shared inputs.
struct Row {
  std::string file;
  std::string kind;
  int duplicate_points = 0;
  int proper_crossings = 0;
};

std::vector<Row> rows_of_text_files(const std::string& corpus) {
  std::ifstream table(corpus + "/CLASSES.csv");
  std::vector<Row> rows;
  std::string line;
  while (std::getline(table, line)) {
    std::vector<std::string> cells;
    std::istringstream columns(line);
    for (std::string cell; std::getline(columns, cell, ',');) cells.push_back(cell);
    if (cells.size() < 11 || cells[0].rfind("artem-ogre__CDT/", 0) != 0) continue;
    rows.push_back({cells[0], cells[1], std::stoi(cells[4]), std::stoi(cells[8])});
  }
  return rows;
}

/// "num_points num_segments", the points, the segments. A triangle around all closes what is open.
Domain read_enclosed(const std::string& path) {
  std::ifstream file(path);
  std::size_t num_points = 0, num_segments = 0;
  file >> num_points >> num_segments;
  Domain domain;
  domain.points.resize(num_points);
  for (Point& p : domain.points) file >> p.x >> p.y;
  domain.segments.resize(num_segments);
  for (Segment& s : domain.segments) file >> s.a >> s.b;
  const int n = static_cast<int>(num_points);
  domain.points.insert(domain.points.end(), {{-1e7, -1e7}, {1e7, -1e7}, {0, 1e7}});
  domain.segments.insert(domain.segments.end(), {{n, n + 1, 1}, {n + 1, n + 2, 1}, {n + 2, n, 1}});
  return domain;
}

}  // namespace

TEST_CASE("clean agrees with the exact classification of the shared inputs", "[mesher][domain][shared]") {
  const auto shared = support::shared_dir();
  if (!shared) return;
  const std::vector<Row> rows = rows_of_text_files(*shared + "/corpus");
  REQUIRE(rows.size() > 30);
  for (const Row& row : rows) {
    INFO(row.file);
    const Domain domain = read_enclosed(*shared + "/corpus/" + row.file);
    if (row.kind == "bad-index" || row.kind == "invalid-crossing") {
      CHECK_THROWS_AS(clean(domain), GeometryError);
      continue;
    }
    REQUIRE_NOTHROW(clean(domain));
    const Domain cleaned = clean(domain).domain;
    CHECK(static_cast<int>(domain.points.size() - cleaned.points.size()) == row.duplicate_points);
    CHECK(row.proper_crossings == 0);
    CHECK(clean(cleaned).domain.segments.size() == cleaned.segments.size());
  }
}
