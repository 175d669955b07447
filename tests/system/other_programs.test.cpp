#include <catch2/catch.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "mesher/io/mesh_file.h"
#include "mesher/io/msh.h"
#include "tests/mesher/io/canonical_mesh.h"
#include "tests/mesher/io/sample_mesh.h"
#include "tests/system/program.h"

// Files are proved with the programs of others, where these are installed (Debian: gmsh, python3-meshio, freefem++).

using parmesan::Encoding;
using parmesan::Mesh;
using parmesan::MeshFields;
using parmesan::support::canonical;
using parmesan::support::is_installed;
using parmesan::support::ProgramResult;
using parmesan::support::run_other;
using parmesan::support::run_program;
using parmesan::support::same_arrays;
using parmesan::support::sample_mesh;
using parmesan::support::TemporaryFolder;

namespace {

const std::string python = "/usr/bin/python3";

bool has_meshio() {
  if (run_other(python, {"-c", "import meshio"}).exit_code == 0) return true;
  std::cout << "skipped: there is no meshio for " << python << "\n";
  return false;
}

/// Labels that Gmsh cannot number, and names.
Mesh named_mesh() {
  Mesh mesh = sample_mesh(4);
  for (int& label : mesh.labels) label -= 2;
  mesh.label_names = {{1, "wall"}, {2, "outflow with blanks"}};
  mesh.region_names = {{7, "steel"}};
  return mesh;
}

MeshFields fields_of(const Mesh& mesh) {
  MeshFields fields{{{"u", 1, {}}, {"v", 2, {}}}, {{"m", 3, {}}}};
  for (const auto& p : mesh.points) {
    fields.points[0].values.push_back(p.x / 3.0);
    fields.points[1].values.insert(fields.points[1].values.end(), {p.y, -p.x});
  }
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    fields.cells[0].values.insert(fields.cells[0].values.end(), {1.0 + t, 0.1 * t, 7.0});
  }
  return fields;
}

/// Runs a Python program in the folder; what it prints is the JSON returned.
nlohmann::json run_python(const std::string& text, const TemporaryFolder& folder) {
  const ProgramResult result = run_other(python, {"-c", text}, folder.path());
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return nlohmann::json::parse(result.out);
}

/// Prints points, lines, triangles and fields of a file as meshio sees them.
std::string dump(const std::string& name) {
  return "import meshio, json, contextlib, sys\n"
         "with contextlib.redirect_stdout(sys.stderr): m = meshio.read('" +
         name +
         "')\n"
         "cells = lambda kind: [list(map(int, c)) for b in m.cells if b.type == kind for c in b.data]\n"
         "print(json.dumps({'points': m.points[:, :2].tolist(), 'line': cells('line'), 'triangle': cells('triangle'),"
         " 'point_data': {k: v.tolist() for k, v in m.point_data.items()},"
         " 'cell_data': {k: [b.tolist() for b in v] for k, v in m.cell_data.items()},"
         " 'names': sorted(m.field_data)}))";
}

void check_same(const nlohmann::json& read, const Mesh& mesh) {
  REQUIRE(read.at("points").size() == mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    CHECK(read.at("points")[i] == nlohmann::json{mesh.points[i].x, mesh.points[i].y});
  }
  CHECK(read.at("triangle").get<std::vector<std::array<int, 3>>>() == mesh.triangles);
}

}  // namespace

TEST_CASE("meshio reads our Medit meshes and gives back the same arrays", "[system][others]") {
  if (!has_meshio()) return;
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(6);
  const std::string name = GENERATE("m.mesh", "m.meshb");
  parmesan::write_mesh_file(folder / name, mesh);
  const nlohmann::json read = run_python(dump(name), folder);
  check_same(read, mesh);
  CHECK(read.at("line").get<std::vector<std::array<int, 2>>>() == mesh.edges);
  CHECK(read.at("cell_data").at("medit:ref") == nlohmann::json{mesh.labels, mesh.regions});
}

TEST_CASE("meshio reads our .vtu and gives back the same arrays", "[system][others]") {
  if (!has_meshio()) return;
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(6);
  const MeshFields fields = fields_of(mesh);
  parmesan::write_mesh_file(folder / "m.vtu", mesh, fields);
  const nlohmann::json read = run_python(dump("m.vtu"), folder);
  check_same(read, mesh);
  CHECK(read.at("point_data").at("u") == fields.points[0].values);
  CHECK(read.at("point_data").at("v")[5] == nlohmann::json{mesh.points[5].y, -mesh.points[5].x, 0.0});
  CHECK(read.at("cell_data").at("region")[0] == mesh.regions);
}

TEST_CASE("meshio reads our Gmsh meshes with their fields at vertices and names", "[system][others]") {
  if (!has_meshio()) return;
  const TemporaryFolder folder;
  const Mesh mesh = named_mesh();
  MeshFields fields = fields_of(mesh);
  fields.cells.clear();  // meshio 5.0 wants a value for lines too
  const Encoding encoding = GENERATE(Encoding::Text, Encoding::Binary);
  parmesan::write_msh(folder / "m.msh", mesh, fields, encoding);
  const nlohmann::json read = run_python(dump("m.msh"), folder);
  check_same(read, mesh);  // the regions of the sample follow each other, so blocks keep the order
  CHECK(read.at("point_data").at("u") == fields.points[0].values);
  CHECK(read.at("names") == nlohmann::json{"-1", "0", "outflow with blanks", "steel", "wall"});
}

TEST_CASE("We read what meshio writes", "[system][others]") {
  if (!has_meshio()) return;
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(5);
  parmesan::write_mesh_file(folder / "m.mesh", mesh);
  parmesan::write_mesh_file(folder / "m.msh", mesh);
  run_python(
      "import meshio\nm = meshio.read('m.mesh')\nmeshio.write('o.mesh', m)\nmeshio.write('o.meshb', m)\n"
      "for v in (('gmsh22', 'o22.msh'), ('gmsh', 'o41.msh')):\n"
      "  for b in (True, False):\n"
      "    meshio.write(('b' if b else 't') + v[1], meshio.read('m.msh'), file_format=v[0], binary=b)\n"
      "print('{}')",
      folder);
  for (const char* name : {"o.mesh", "o.meshb"}) {
    CAPTURE(name);
    CHECK(same_arrays(parmesan::read_mesh_file(folder / name), mesh));
  }
  for (const char* name : {"bo22.msh", "to22.msh"}) {
    CAPTURE(name);
    CHECK(canonical(parmesan::read_mesh_file(folder / name)) == canonical(mesh));
  }
  for (const char* name : {"bo41.msh", "to41.msh"}) {  // meshio 5.0 leaves groups out of these
    CAPTURE(name);
    const Mesh read = parmesan::read_mesh_file(folder / name);
    CHECK(read.points == mesh.points);
    CHECK(read.triangles == mesh.triangles);
    CHECK(read.edges.size() == mesh.edges.size());
  }
}

TEST_CASE("Gmsh opens our meshes and what it writes of them is the same mesh", "[system][others]") {
  if (!is_installed("gmsh")) return;
  const TemporaryFolder folder;
  const Mesh mesh = named_mesh();
  const Encoding encoding = GENERATE(Encoding::Text, Encoding::Binary);
  const std::string format = GENERATE("msh41", "msh22");
  const bool binary = GENERATE(false, true);
  CAPTURE(format, binary);
  parmesan::write_msh(folder / "m.msh", mesh, fields_of(mesh), encoding);
  std::vector<std::string> arguments{folder / "m.msh", "-save", "-format", format, "-o", folder / "o.msh"};
  if (binary) arguments.emplace_back("-bin");
  const ProgramResult result = run_other("gmsh", arguments);
  INFO(result.out << result.err);
  REQUIRE(result.exit_code == 0);
  CHECK((result.out + result.err).find("Error") == std::string::npos);
  CHECK((result.out + result.err).find("Warning") == std::string::npos);
  CHECK(canonical(parmesan::read_mesh_file(folder / "o.msh")) == canonical(mesh));
}

TEST_CASE("A mesh that Gmsh makes of a geometry is one that we can use", "[system][others]") {
  if (!is_installed("gmsh")) return;
  const TemporaryFolder folder;
  // A disc of steel in a square of air. Seen from below, so that all triangles are clockwise; one side has no name.
  folder.write("g.geo",
               "h = 0.2;\nPoint(1) = {0,0,0,h}; Point(2) = {0,1,0,h}; Point(3) = {1,1,0,h}; Point(4) = {1,0,0,h};\n"
               "Point(5) = {0.5,0.5,0,h}; Point(6) = {0.7,0.5,0,h}; Point(7) = {0.3,0.5,0,h};\n"
               "Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1};\n"
               "Circle(5) = {6,5,7}; Circle(6) = {7,5,6};\n"
               "Curve Loop(1) = {1,2,3,4}; Curve Loop(2) = {5,6};\n"
               "Plane Surface(1) = {1,2}; Plane Surface(2) = {2};\n"
               "Physical Curve(\"left\", 11) = {1}; Physical Curve(\"rest\", 12) = {2,3};\n"
               "Physical Surface(\"air\", 21) = {1}; Physical Surface(\"steel\", 22) = {2};\n");
  const std::string format = GENERATE("msh41", "msh22");
  CAPTURE(format);
  REQUIRE(run_other("gmsh", {folder / "g.geo", "-2", "-format", format, "-o", folder / "g.msh"}).exit_code == 0);
  const Mesh mesh = parmesan::read_valid_mesh(folder / "g.msh");
  CHECK(mesh.label_names == parmesan::LabelNames{{11, "left"}, {12, "rest"}});
  CHECK(mesh.region_names == parmesan::LabelNames{{21, "air"}, {22, "steel"}});
  const ProgramResult made =
      run_program({"mesh", folder / "g.msh", "--size", "0.1", "-o", folder / "out.msh", "--require", "unit=0.8"});
  INFO(made.err);
  CHECK(made.exit_code == 0);
  const Mesh out = parmesan::read_valid_mesh(folder / "out.msh");
  CHECK(out.label_names == mesh.label_names);
  CHECK(out.region_names == mesh.region_names);
}

TEST_CASE("FreeFEM reads our mesh, and we read the one it adapts", "[system][others]") {
  if (!is_installed("FreeFem++")) return;
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(8);
  parmesan::write_mesh_file(folder / "m.mesh", mesh);
  folder.write("a.edp",
               "mesh Th = readmesh(\"m.mesh\");\n"
               "cout << \"COUNTS \" << Th.nv << \" \" << Th.nt << \" \" << Th.nbe << \" \" << Th.measure << endl;\n"
               "fespace Vh(Th, P1);\nVh u = x*x + 10*y*y;\nTh = adaptmesh(Th, u, err=0.01);\n"
               "savemesh(Th, \"o.mesh\");\n");
  const ProgramResult result = run_other("FreeFem++", {"-nw", "-v", "0", "a.edp"}, folder.path());
  INFO(result.out << result.err);
  REQUIRE(result.exit_code == 0);
  // 32 sides of the boundary, and the 8 between the regions, which FreeFEM adds.
  CHECK_THAT(result.out, Catch::Contains("COUNTS 81 128 40 1"));
  const Mesh adapted = parmesan::read_valid_mesh(folder / "o.mesh");
  CHECK(adapted.num_triangles() > 20);
}

TEST_CASE("bamg adapts our mesh, and we read what it makes", "[system][others]") {
  if (!is_installed("ffbamg")) return;
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(8);
  parmesan::write_mesh_file(folder / "m.mesh", mesh);
  std::string metric = "81 3\n";
  for (int i = 0; i < 81; ++i) metric += "100 0 400\n";
  folder.write("m.mtr", metric);
  const ProgramResult result =
      run_other("ffbamg", {"-b", "m.mesh", "-M", "m.mtr", "-o", "o.mesh", "-v", "1"}, folder.path());
  INFO(result.out << result.err);
  REQUIRE(result.exit_code == 0);
  // Complexity sqrt(100 * 400) = 200; a unit mesh has 4 / sqrt3 triangles per unit of it.
  CHECK(parmesan::read_valid_mesh(folder / "o.mesh").num_triangles() == Approx(462).epsilon(0.15));
}

TEST_CASE("A .pvd file is XML that lists files that are there", "[system][others]") {
  const TemporaryFolder folder;
  const ProgramResult run = run_program({"run", std::string(PARMESAN_SOURCE_DIR) + "/cases/gaussian.json", "--out", "o",
                                         "--set", "/targets/max_iterations=2", "--quiet"},
                                        folder.path());
  INFO(run.err);
  if (!has_meshio()) return;
  const nlohmann::json read = run_python(
      "import xml.etree.ElementTree as X, meshio, json\n"
      "sets = X.parse('o/run.pvd').getroot().find('Collection').findall('DataSet')\n"
      "print(json.dumps([[float(s.get('timestep')), len(meshio.read('o/' + s.get('file')).points)] for s in sets]))",
      folder);
  REQUIRE(read.size() >= 1);
  CHECK(read[0][0] == 0.0);
  CHECK(read[0][1] > 3);
}

TEST_CASE("Ghostscript draws our EPS within its bounds", "[system][others]") {
  if (!is_installed("gs")) return;
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(30);
  parmesan::write_mesh_file(folder / "m.eps", mesh, fields_of(mesh));
  const ProgramResult result =
      run_other("gs", {"-q", "-dSAFER", "-dBATCH", "-dNOPAUSE", "-sDEVICE=bbox", folder / "m.eps"});
  INFO(result.out << result.err);
  REQUIRE(result.exit_code == 0);
  // "%%BoundingBox: left bottom right top" of all that is not white; the picture is 900 wide, its mesh about 750.
  std::istringstream words(result.err.substr(result.err.find(' ')));
  double left = 0.0, bottom = 0.0, right = 0.0, top = 0.0;
  words >> left >> bottom >> right >> top;
  CHECK(left >= 0.0);
  CHECK(bottom >= 0.0);
  CHECK(right <= 900.0);
  CHECK(right - left > 750.0);
  CHECK(top - bottom > 700.0);
}
