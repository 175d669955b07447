#include "mesher/io/mesh_file.h"

#include <catch2/catch.hpp>

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
