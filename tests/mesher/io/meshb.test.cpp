#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "tests/mesher/io/error_line.h"
#include "tests/mesher/io/gmf_bytes.h"
#include "tests/mesher/io/sample_mesh.h"
#include "tests/support/temporary_folder.h"

using parmesan::FileError;
using parmesan::Mesh;
using parmesan::parse_meshb;
using parmesan::read_meshb;
using parmesan::write_meshb;
using parmesan::support::content_of;
using parmesan::support::error_message;
using parmesan::support::GmfBytes;
using parmesan::support::one_triangle;
using parmesan::support::same_arrays;
using parmesan::support::sample_mesh;
using parmesan::support::TemporaryFolder;

namespace gmf = parmesan::support::gmf;

namespace {

std::string message_of(const std::string& bytes) {
  return error_message([&bytes] { parse_meshb(bytes, "t.meshb"); });
}

/// The head of a file with three vertices, to which a section can be added.
GmfBytes three_vertices() {
  GmfBytes file(2, false);
  file.keyword(gmf::dimension).append<std::int32_t>(2);
  file.keyword(gmf::vertices).integer(3);
  for (int i = 0; i < 3; ++i) file.real(i).real(i * i).integer(0);
  return file;
}

}  // namespace

TEST_CASE("A mesh comes back from binary Medit bit by bit", "[mesher][io][meshb]") {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh(5);
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> any_int(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  for (parmesan::Point& p : mesh.points) p = {std::pow(10.0, exponent(random)), -std::pow(10.0, exponent(random))};
  for (int& label : mesh.labels) label = any_int(random);
  for (int& region : mesh.regions) region = any_int(random);
  write_meshb(folder / "m.meshb", mesh);
  CHECK(same_arrays(read_meshb(folder / "m.meshb"), mesh));
  mesh.triangles.clear();
  mesh.regions.clear();
  write_meshb(folder / "m.meshb", mesh);
  CHECK(same_arrays(read_meshb(folder / "m.meshb"), mesh));
}

TEST_CASE("All versions and byte orders of binary Medit are read", "[mesher][io][meshb]") {
  const int version = GENERATE(1, 2, 3, 4);
  const bool swapped = GENERATE(false, true);
  CAPTURE(version, swapped);
  const Mesh mesh = parse_meshb(one_triangle(version, swapped), "t.meshb");
  CHECK(mesh.points == std::vector<parmesan::Point>{{0, 0}, {1, 0}, {0, 1}});
  CHECK(mesh.edges == std::vector<std::array<int, 2>>{{0, 1}, {1, 2}});
  CHECK(mesh.labels == std::vector<int>{10, -4});
  CHECK(mesh.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}});
  CHECK(mesh.regions == std::vector<int>{6});
}

TEST_CASE("A binary Medit mesh in space must lie in the plane", "[mesher][io][meshb]") {
  const auto with_z = [](double z) {
    GmfBytes file(2, false);
    file.keyword(gmf::dimension).append<std::int32_t>(3);
    file.keyword(gmf::vertices).integer(1).real(1.0).real(2.0).real(z).integer(0);
    return file.keyword(gmf::end).bytes();
  };
  CHECK(parse_meshb(with_z(0.0), "t.meshb").points == std::vector<parmesan::Point>{{1, 2}});
  // 8 bytes of head, Dimension 12, keyword, place and count 12, x and y 16
  CHECK(message_of(with_z(0.5)) == "t.meshb: at byte 48: z is not 0: the mesh must lie in the plane");
}

TEST_CASE("Every fault in a binary Medit mesh is refused with its byte", "[mesher][io][meshb][errors]") {
  using Catch::Contains;
  CHECK_THAT(message_of(""), Contains("at byte 0"));
  CHECK_THAT(message_of("MeshVersionFormatted 2\n"), Contains("at byte 0") && Contains("no binary Medit file"));
  CHECK_THAT(message_of(GmfBytes(5, false).bytes()), Contains("at byte 4") && Contains("known are 1 to 4"));
  CHECK_THAT(message_of(GmfBytes(2, false).keyword(gmf::end).bytes()), Contains("Dimension is missing"));
  GmfBytes no_vertices(2, false);
  no_vertices.keyword(gmf::dimension).append<std::int32_t>(2).keyword(gmf::end);
  CHECK_THAT(message_of(no_vertices.bytes()), Contains("Vertices is missing"));
  CHECK_THAT(
      message_of(
          three_vertices().keyword(gmf::edges).integer(1).integer(1).integer(4).integer(0).keyword(gmf::end).bytes()),
      Contains("is 4, must be from 1 to 3"));
  CHECK_THAT(message_of(three_vertices().keyword(gmf::edges).integer(-1).keyword(gmf::end).bytes()),
             Contains("is negative"));
  CHECK_THAT(message_of(three_vertices().keyword(gmf::edges).integer(2000000000).keyword(gmf::end).bytes()),
             Contains("cut off"));
  CHECK_THAT(message_of(three_vertices().keyword(gmf::edges).integer(0).integer(0).keyword(gmf::end).bytes()),
             Contains("is a count wrong?"));
  CHECK_THAT(message_of(three_vertices()
                            .keyword(gmf::quadrilaterals)
                            .integer(1)
                            .integer(1)
                            .integer(1)
                            .integer(1)
                            .integer(1)
                            .integer(0)
                            .keyword(gmf::end)
                            .bytes()),
             Contains("not triangles"));
  CHECK_THAT(message_of(three_vertices().keyword(gmf::vertices).integer(0).keyword(gmf::end).bytes()),
             Contains("second time"));
  GmfBytes not_finite(2, false);
  not_finite.keyword(gmf::dimension).append<std::int32_t>(2).keyword(gmf::vertices).integer(1);
  not_finite.real(0.0).real(std::nan("")).integer(0).keyword(gmf::end);
  CHECK_THAT(message_of(not_finite.bytes()), Contains("y coordinate is not finite"));
}

TEST_CASE("A binary Medit mesh whose keywords go round in circles is refused", "[mesher][io][meshb][errors]") {
  GmfBytes file(2, false);
  file.append<std::int32_t>(gmf::dimension).append<std::int32_t>(8).append<std::int32_t>(2);
  CHECK_THAT(message_of(file.bytes()), Catch::Contains("not behind it"));
}

TEST_CASE("A binary Medit mesh that is cut off anywhere is refused", "[mesher][io][meshb][errors]") {
  const std::string bytes = one_triangle(2, false);
  REQUIRE_NOTHROW(parse_meshb(bytes, "t.meshb"));
  for (std::size_t length = 0; length + 4 < bytes.size(); ++length) {  // without the place that follows End
    CAPTURE(length);
    CHECK_THROWS_AS(parse_meshb(bytes.substr(0, length), "t.meshb"), FileError);
  }
}

TEST_CASE("A binary Medit mesh with any byte changed is read or refused", "[mesher][io][meshb][errors]") {
  const std::string bytes = one_triangle(GENERATE(1, 2, 3, 4), GENERATE(false, true));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const char c : {'\0', '\1', '\x7f', '\x80', '\xff'}) {
      std::string changed = bytes;
      changed[i] = c;
      try {
        const Mesh mesh = parse_meshb(changed, "t.meshb");
        CHECK(mesh.regions.size() == mesh.triangles.size());
      } catch (const FileError&) {
        SUCCEED();
      }
    }
  }
}

TEST_CASE("Coordinates that are not finite are not written in binary", "[mesher][io][meshb][errors]") {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh(2);
  mesh.points[3].y = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(write_meshb(folder / "m.meshb", mesh), FileError);
  CHECK(folder.num_files() == 0);
}
