#include "mesher/io/eps.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>
#include <string>

#include "mesher/errors.h"
#include "tests/mesher/io/sample_mesh.h"
#include "tests/support/temporary_folder.h"

using parmesan::Mesh;
using parmesan::PictureOptions;
using parmesan::write_eps;
using parmesan::support::content_of;
using parmesan::support::sample_mesh;
using parmesan::support::TemporaryFolder;

namespace {

std::string eps(const Mesh& mesh, const PictureOptions& options) {
  const TemporaryFolder folder;
  write_eps(folder / "m.eps", mesh, options);
  return content_of(folder / "m.eps");
}

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("An EPS file has its head, its bounds and one piece per side", "[mesher][io][eps]") {
  PictureOptions options;
  options.show_axes = false;
  const std::string picture = eps(sample_mesh(3), options);
  CHECK_THAT(picture, Catch::StartsWith("%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 900 "));
  CHECK_THAT(picture, Catch::EndsWith("%%EOF\n"));
  // 33 sides of 18 triangles, and the 12 boundary edges drawn once more.
  CHECK(count(picture, " m\n") == 33 + 12);
}

TEST_CASE("Paths of an EPS file stay short enough for every interpreter", "[mesher][io][eps]") {
  std::istringstream lines(eps(sample_mesh(40), {}));
  int length = 0;
  int longest = 0;
  for (std::string line; std::getline(lines, line);) {
    length = line == "s" || line.ends_with(" f") ? 0 : length + 1;
    longest = std::max(longest, length);
  }
  CHECK(longest < 1500);
}

TEST_CASE("Texts of an EPS file cannot end their string", "[mesher][io][eps]") {
  const Mesh mesh = sample_mesh(2);
  const std::vector<double> values(mesh.points.size(), 1.0);
  PictureOptions options;
  options.title = "a) showpage (\\ \xc3\xa4\n";
  options.values = values;
  options.values_name = "u";
  const std::string picture = eps(mesh, options);
  CHECK_THAT(picture, Catch::Contains("(a\\) showpage \\(\\\\ ?"
                                      "?)") &&
                          Catch::Contains("(u)"));
}
