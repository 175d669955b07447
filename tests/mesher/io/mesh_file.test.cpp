#include "mesher/io/mesh_file.h"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "tests/mesher/io/error_line.h"
#include "tests/mesher/io/sample_mesh.h"
#include "tests/support/temporary_folder.h"

using parmesan::check_mesh_file_name;
using parmesan::FileError;
using parmesan::Mesh;
using parmesan::read_mesh_file;
using parmesan::write_mesh_file;
using parmesan::support::content_of;
using parmesan::support::error_message;
using parmesan::support::same_arrays;
using parmesan::support::sample_mesh;
using parmesan::support::TemporaryFolder;

TEST_CASE("The suffix names the format of a mesh", "[mesher][io]") {
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(3);
  for (const char* name : {"a.mesh", "b.node", "c.ele", "d.Mesh", "g.meshb", "h.msh"}) {
    CAPTURE(name);
    CHECK_NOTHROW(check_mesh_file_name(folder / name));
    write_mesh_file(folder / name, mesh);
    CHECK(same_arrays(read_mesh_file(folder / name), mesh));
  }
  write_mesh_file(folder / "e.vtu", mesh);
  CHECK_THAT(content_of(folder / "e.vtu"), Catch::Contains("<VTKFile"));
  write_mesh_file(folder / "f.svg", mesh);
  CHECK_THAT(content_of(folder / "f.svg"), Catch::StartsWith("<svg"));
  write_mesh_file(folder / "f.eps", mesh);
  CHECK_THAT(content_of(folder / "f.eps"), Catch::StartsWith("%!PS-Adobe"));
  write_mesh_file(folder / "f.poly", mesh);
  CHECK_THAT(content_of(folder / "f.poly"), Catch::StartsWith("6 2 0 0\n"));  // corners, and ends of the border inside
}

TEST_CASE("An unknown suffix of a mesh is refused with the known ones", "[mesher][io][errors]") {
  const TemporaryFolder folder;
  for (const char* name : {"m", "m.stl", "mesh.", ".mesh/m", "m.mesh.gz"}) {
    CAPTURE(name);
    CHECK_THAT(error_message([&] { check_mesh_file_name(folder / name); }), Catch::Contains(".vtu .svg .eps"));
    CHECK_THROWS_AS(write_mesh_file(folder / name, Mesh{}), FileError);
    CHECK_THROWS_AS(read_mesh_file(folder / name), FileError);
  }
  CHECK_THROWS_AS(read_mesh_file(folder.write("m.vtu", "<VTKFile>")), FileError);
}

TEST_CASE("Fields that are older than the mesh beside them are told of", "[mesher][io]") {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(2);
  const parmesan::MeshFields fields{{{"u", 1, std::vector<double>(mesh.points.size(), 1.0)}}, {}};
  const bool is_binary = GENERATE(false, true);
  const std::string path = folder / (is_binary ? "m.meshb" : "m.mesh");
  const std::string fields_path = folder / (is_binary ? "m.solb" : "m.sol");
  write_mesh_file(path, mesh, fields);
  CHECK(parmesan::read_mesh_data(path).notes.empty());
  fs::last_write_time(fields_path, fs::last_write_time(path) - std::chrono::hours(1));
  const parmesan::MeshData read = parmesan::read_mesh_data(path);
  CHECK(read.fields.points.size() == 1);
  REQUIRE(read.notes.size() == 1);
  CHECK_THAT(read.notes[0], Catch::StartsWith(fields_path) && Catch::Contains("is older than " + path));
  // Where they do not even fit, age is the likely reason.
  write_mesh_file(path, sample_mesh(3));
  CHECK_THAT(error_message([&] { parmesan::read_mesh_data(path); }), Catch::Contains("is older than " + path));
}

TEST_CASE("What readers of a written mesh will miss or mistake is told", "[mesher][io]") {
  using parmesan::notes_on_written;
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh(2);
  const parmesan::MeshFields fields{{{"u", 1, std::vector<double>(mesh.points.size(), 1.0)}}, {}};
  SECTION("fields from before beside a mesh without any") {
    CHECK(notes_on_written(folder / "m.mesh", mesh).empty());
    folder.write("m.sol", "");
    for (const char* name : {"m.mesh", "m.meshb"}) {
      REQUIRE(notes_on_written(folder / name, mesh).size() == 1);
      CHECK_THAT(notes_on_written(folder / name, mesh)[0], Catch::StartsWith(folder / "m.sol is there from before"));
      CHECK(notes_on_written(folder / name, mesh, fields).empty());
    }
    for (const char* name : {"m.msh", "m.node", "m.vtu", "other.mesh"})
      CHECK(notes_on_written(folder / name, mesh).empty());
  }
  SECTION("what Triangle's files do not hold") {
    mesh.labels[0] = 0;  // on the boundary they may
    CHECK(notes_on_written(folder / "m.node", mesh).empty());
    CHECK_THAT(notes_on_written(folder / "m.node", mesh, fields).at(0), Catch::Contains("hold no fields"));
    mesh.edges.push_back({0, 4});  // a diagonal
    mesh.labels.push_back(0);
    CHECK_THAT(notes_on_written(folder / "m.ele", mesh).at(0),
               Catch::Contains("1 edge inside of the mesh has label 0"));
    write_mesh_file(folder / "m.node", mesh);
    CHECK(read_mesh_file(folder / "m.node").edges.size() + 1 == mesh.edges.size());
  }
}
