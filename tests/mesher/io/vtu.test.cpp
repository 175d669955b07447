#include "mesher/io/vtu.h"

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstring>
#include <string>

#include "mesher/errors.h"
#include "tests/mesher/io/sample_mesh.h"
#include "tests/support/temporary_folder.h"

using parmesan::InputError;
using parmesan::Mesh;
using parmesan::Metric;
using parmesan::write_vtu;
using parmesan::support::content_of;
using parmesan::support::sample_mesh;
using parmesan::support::TemporaryFolder;

namespace {

/// Base64 letter by letter into a bit buffer.
std::string decode(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned buffer = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    buffer = buffer << 6U | static_cast<unsigned>(letters.find(c));
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes += static_cast<char>(buffer >> static_cast<unsigned>(bits) & 255U);
    }
  }
  return bytes;
}

/// The numbers of the data array of this name, after a check of its declared size.
template <class Number>
std::vector<Number> array_of(const std::string& file, const std::string& name) {
  const std::size_t element = file.find("Name=\"" + name + "\"");
  REQUIRE(element != std::string::npos);
  const std::size_t begin = file.find('>', element) + 1;
  const std::string bytes = decode(file.substr(begin, file.find('<', begin) - begin));
  std::uint64_t size = 0;
  REQUIRE(bytes.size() >= sizeof(size));
  std::memcpy(&size, bytes.data(), sizeof(size));
  REQUIRE(bytes.size() == sizeof(size) + size);
  std::vector<Number> numbers(size / sizeof(Number));
  if (size > 0) std::memcpy(numbers.data(), bytes.data() + sizeof(size), size);
  return numbers;
}

}  // namespace

TEST_CASE("A .vtu file holds the mesh and its fields", "[mesher][io][vtu]") {
  const int n = GENERATE(1, 2, 3, 20);  // sizes that leave 0, 1 and 2 bytes over in base64
  CAPTURE(n);
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(n);
  std::vector<double> u;
  for (const auto& p : mesh.points) u.push_back(p.x - 3.0 * p.y);
  const std::vector<Metric> metrics(mesh.triangles.size(), Metric::from_sizes(0.5, 2.0, 0.3));
  write_vtu(folder / "m.vtu", mesh, {{{"u <&>", 1, u}}, {tensor_field("M", metrics)}});
  const std::string file = content_of(folder / "m.vtu");

  const auto points = array_of<double>(file, "Points");
  REQUIRE(points.size() == 3 * mesh.points.size());
  CHECK(points[3] == mesh.points[1].x);
  CHECK(points[points.size() - 2] == mesh.points.back().y);
  CHECK(points.back() == 0.0);
  const auto connectivity = array_of<std::int32_t>(file, "connectivity");
  REQUIRE(connectivity.size() == 3 * mesh.triangles.size());
  CHECK(connectivity.back() == mesh.triangles.back()[2]);
  CHECK(array_of<std::int64_t>(file, "offsets").back() == static_cast<std::int64_t>(connectivity.size()));
  CHECK(array_of<std::uint8_t>(file, "types") == std::vector<std::uint8_t>(mesh.triangles.size(), 5));
  CHECK(array_of<std::int32_t>(file, "region") == mesh.regions);
  CHECK(array_of<double>(file, "u &lt;&amp;&gt;") == u);
  const auto tensors = array_of<double>(file, "M");
  REQUIRE(tensors.size() == 9 * metrics.size());
  const auto& m = metrics[0].tensor();
  CHECK(std::vector<double>(tensors.begin(), tensors.begin() + 9) ==
        std::vector<double>{m.xx, m.xy, 0, m.xy, m.yy, 0, 0, 0, 0});
}

TEST_CASE("A .vtu file marks required vertices and triangles, if there are any", "[mesher][io][vtu]") {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh(2);
  write_vtu(folder / "none.vtu", mesh);
  CHECK(content_of(folder / "none.vtu").find("required") == std::string::npos);
  mesh.required = {{0, 3}, {1}, {7}};
  write_vtu(folder / "m.vtu", mesh);
  const std::string file = content_of(folder / "m.vtu");
  CHECK(array_of<std::uint8_t>(file, "required") == std::vector<std::uint8_t>{1, 0, 0, 1, 0, 0, 0, 0, 0});
  const std::string cells = file.substr(file.find("<CellData>"));
  CHECK(array_of<std::uint8_t>(cells, "required") == std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 1});
}

TEST_CASE("An empty mesh has an empty .vtu file", "[mesher][io][vtu]") {
  const TemporaryFolder folder;
  write_vtu(folder / "m.vtu", Mesh{});
  CHECK(array_of<double>(content_of(folder / "m.vtu"), "Points").empty());
}

TEST_CASE("Fields of the wrong size are refused", "[mesher][io][vtu][errors]") {
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(2);  // 9 vertices, 8 triangles
  CHECK_THROWS_AS(write_vtu(folder / "m.vtu", mesh, {{{"u", 1, std::vector<double>(8)}}, {}}), InputError);
  CHECK_THROWS_AS(write_vtu(folder / "m.vtu", mesh, {{}, {{"u", 1, std::vector<double>(9)}}}), InputError);
  CHECK_THROWS_AS(write_vtu(folder / "m.vtu", mesh, {{{"u", 0, {}}}, {}}), InputError);
  CHECK_NOTHROW(write_vtu(folder / "n.vtu", mesh, {{{"v", 2, std::vector<double>(18)}}, {}}));
  CHECK(folder.num_files() == 1);
}

TEST_CASE("A .pvd file lists its meshes with their times", "[mesher][io][vtu]") {
  const TemporaryFolder folder;
  const std::vector<parmesan::PvdEntry> entries{{0.0, "a/0.vtu"}, {1.5, "b&c.vtu"}};
  parmesan::write_pvd(folder / "run.pvd", entries);
  const std::string file = content_of(folder / "run.pvd");
  CHECK_THAT(file, Catch::Contains("<DataSet timestep=\"0\" part=\"0\" file=\"a/0.vtu\"/>"));
  CHECK_THAT(file, Catch::Contains("<DataSet timestep=\"1.5\" part=\"0\" file=\"b&amp;c.vtu\"/>"));
}
