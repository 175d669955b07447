#include "mesher/io/msh.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/errors.h"
#include "mesher/validate.h"
#include "tests/mesher/io/canonical_mesh.h"
#include "tests/mesher/io/error_line.h"
#include "tests/mesher/io/sample_mesh.h"
#include "tests/support/temporary_folder.h"

using parmesan::Encoding;
using parmesan::FileError;
using parmesan::Mesh;
using parmesan::MeshData;
using parmesan::MeshFields;
using parmesan::parse_msh;
using parmesan::read_msh;
using parmesan::write_msh;
using parmesan::support::canonical;
using parmesan::support::content_of;
using parmesan::support::error_line;
using parmesan::support::error_message;
using parmesan::support::same_arrays;
using parmesan::support::sample_mesh;
using parmesan::support::TemporaryFolder;

namespace {

const std::string format_4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string format_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string names = "$PhysicalNames\n2\n1 7 \"lower # side\"\n2 9 \"steel\"\n$EndPhysicalNames\n";
const std::string entities =
    "$Entities\n1 1 1 0\n1 0 0 0 0\n3 0 0 0 1 0 0 1 7 2 1 -2\n4 0 0 0 1 1 0 2 9 8 1 3\n$EndEntities\n";
// Nodes with gaps in their tags, in blocks; node 50 is the centre of an arc, which nothing uses.
const std::string msh_nodes =
    "$Nodes\n3 5 10 50\n0 1 0 1\n50\n5 5 5\n1 3 1 2\n10\n20\n0 0 0 0.5\n1 0 0 0.7\n2 4 0 2\n30\n40\n1 1 0\n0 1 "
    "0\n$EndNodes\n";
const std::string elements =
    "$Elements\n3 4 1 4\n0 1 15 1\n1 10\n1 3 1 1\n2 20 10\n2 4 2 2\n3 10 20 30\n4 10 40 30\n$EndElements\n";
const std::string node_data = "$NodeData\n1\n\"the u\"\n1\n0.5\n3\n0\n1\n4\n40 4\n30 3\n10 1\n20 2\n$EndNodeData\n";

MeshData parse_msh_text(const std::string& text) { return parse_msh(text, "t.msh"); }
int msh_line_of(const std::string& text) {
  return error_line([&text] { parse_msh_text(text); });
}

MeshFields sample_fields(const Mesh& mesh) {
  MeshFields fields{{{"u", 1, {}}, {"v \"w\"", 2, {}}}, {{"m", 3, {}}}};
  for (const auto& p : mesh.points) {
    fields.points[0].values.push_back(std::sin(p.x + 3 * p.y));
    fields.points[1].values.insert(fields.points[1].values.end(), {p.y, -p.x});
  }
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    fields.cells[0].values.insert(fields.cells[0].values.end(), {1.0 + t, 0.1 * t, 7.0});
  }
  return fields;
}

}  // namespace

TEST_CASE("A mesh and its fields come back from Gmsh's format bit by bit", "[mesher][io][msh]") {
  const TemporaryFolder folder;
  const Encoding encoding = GENERATE(Encoding::Text, Encoding::Binary);
  Mesh mesh = sample_mesh(5);
  for (int& label : mesh.labels) label -= 2;  // -1 to 2: two that Gmsh cannot number
  mesh.regions[3] = 0;
  mesh.label_names[1] = "wall";
  mesh.region_names[7] = "lower part";
  const MeshFields fields = sample_fields(mesh);
  write_msh(folder / "m.msh", mesh, fields, encoding);
  const MeshData back = read_msh(folder / "m.msh");
  CHECK(same_arrays(back.mesh, mesh));
  CHECK(back.mesh.label_names == mesh.label_names);
  CHECK(back.mesh.region_names == mesh.region_names);
  REQUIRE(back.fields.points.size() == 2);
  CHECK(back.fields.points[1].name == "v 'w'");
  CHECK(back.fields.points[0].values == fields.points[0].values);
  CHECK(back.fields.points[1].values == fields.points[1].values);
  REQUIRE(back.fields.cells.size() == 1);
  CHECK(back.fields.cells[0].components == 3);
  CHECK(back.fields.cells[0].values == fields.cells[0].values);
}

TEST_CASE("Lines without triangles come back from Gmsh's format", "[mesher][io][msh]") {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh(1);
  mesh.triangles.clear();
  mesh.regions.clear();
  write_msh(folder / "m.msh", mesh);
  CHECK(same_arrays(read_msh(folder / "m.msh").mesh, mesh));
}

TEST_CASE("Format 4.1 is read with groups, parameters, points and gaps in the tags", "[mesher][io][msh]") {
  const MeshData data = parse_msh_text(format_4 + "$Comments\n\"half a # quote\n$EndComments\n" + names + entities +
                                       msh_nodes + elements + "$Periodic\n0\n$EndPeriodic\n" + node_data);
  const Mesh& mesh = data.mesh;
  CHECK(mesh.points == std::vector<parmesan::Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  // The second triangle is clockwise in the file, and the line has the domain to its right.
  CHECK(mesh.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.regions == std::vector<int>{9, 9});
  CHECK(mesh.edges == std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  CHECK(mesh.labels == std::vector<int>{7, 0, 0, 0});
  CHECK(mesh.label_names == parmesan::LabelNames{{7, "lower # side"}});
  CHECK(mesh.region_names == parmesan::LabelNames{{9, "steel"}});
  CHECK_NOTHROW(parmesan::validate(mesh));
  REQUIRE(data.fields.points.size() == 1);
  CHECK(data.fields.points[0].name == "the u");
  CHECK(data.fields.points[0].values == std::vector<double>{1, 2, 3, 4});
}

TEST_CASE("Parts of a partitioned file have the groups of their parents, borders between parts are left out",
          "[mesher][io][msh]") {
  // The unit square, cut into the partitions 1 and 2 along the diagonal; its lower side is in both.
  const std::string partitioned =
      "$PartitionedEntities\n2\n1\n12 1\n1 3 2 0\n5 0 1 1 1 0 0 0 0\n"
      "6 1 3 1 1 0 0 0 0.5 0 0 1 7 0\n7 1 3 1 2 0.5 0 0 1 0 0 1 7 0\n8 2 4 2 1 2 0 0 0 1 1 0 1 9 0\n"
      "5 2 4 1 1 0 0 0 1 1 0 2 9 8 0\n6 2 4 1 2 0 0 0 1 1 0 2 9 8 0\n$EndPartitionedEntities\n";
  const std::string nodes = "$Nodes\n1 5 1 5\n2 5 0 5\n1\n2\n3\n4\n5\n0 0 0\n0.5 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n";
  const std::string elements_of_parts =
      "$Elements\n5 6 1 6\n1 6 1 1\n1 1 2\n1 7 1 1\n2 2 3\n1 8 1 1\n3 2 4\n2 5 2 2\n4 1 2 4\n5 1 4 5\n"
      "2 6 2 1\n6 2 3 4\n$EndElements\n";
  const Mesh mesh = parse_msh_text(format_4 + names + entities + partitioned + nodes + elements_of_parts).mesh;
  CHECK(mesh.regions == std::vector<int>{9, 9, 9});
  int num_lower = 0;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto y = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(mesh.edges[e][k])].y; };
    const bool is_lower = y(0) == 0.0 && y(1) == 0.0;
    CHECK(mesh.labels[e] == (is_lower ? 7 : 0));
    num_lower += is_lower ? 1 : 0;
  }
  CHECK(num_lower == 2);
  CHECK(mesh.edges.size() == 5);

  // Without groups, the labels are the parents.
  const std::string no_groups =
      "$PartitionedEntities\n2\n0\n0 2 1 0\n6 1 3 1 1 0 0 0 0.5 0 0 0 0\n7 1 4 1 2 0.5 0 0 1 0 0 0 0\n"
      "5 2 4 2 1 2 0 0 0 1 1 0 0 0\n$EndPartitionedEntities\n";
  const std::string elements_of_parents =
      "$Elements\n3 5 1 6\n1 6 1 1\n1 1 2\n1 7 1 1\n2 2 3\n2 5 2 3\n4 1 2 4\n5 1 4 5\n6 2 3 4\n$EndElements\n";
  const Mesh of_parents = parse_msh_text(format_4 + no_groups + nodes + elements_of_parents).mesh;
  CHECK(std::count(of_parents.labels.begin(), of_parents.labels.end(), 3) == 1);
  CHECK(std::count(of_parents.labels.begin(), of_parents.labels.end(), 4) == 1);
}

TEST_CASE("Format 2 is read, elements in two groups once", "[mesher][io][msh]") {
  const std::string text =
      format_2 + names +
      "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
      "$Elements\n6\n1 15 2 0 1 1\n2 1 2 7 3 1 2\n3 1 3 8 3 0 2 1\n4 2 2 9 4 1 2 3\n5 2 2 9 4 1 3 4\n6 2 2 5 4 2 3 1\n"
      "$EndElements\n$ElementData\n1\n\"q\"\n0\n3\n0\n1\n3\n2 5\n5 0.5\n4 0.25\n$EndElementData\n";
  const MeshData data = parse_msh_text(text);
  CHECK(data.mesh.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}});
  CHECK(data.mesh.regions == std::vector<int>{9, 9});
  CHECK(data.mesh.labels == std::vector<int>{7, 0, 0, 0});
  REQUIRE(data.fields.cells.size() == 1);
  CHECK(data.fields.cells[0].values == std::vector<double>{0.25, 0.5});
}

TEST_CASE("Without groups the entities are the labels", "[mesher][io][msh]") {
  const std::string text =
      format_2 +
      "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
      "$Elements\n4\n1 1 2 0 11 1 2\n2 1 2 0 12 2 3\n3 1 2 0 13 3 1\n4 2 2 0 5 1 2 3\n$EndElements\n";
  const Mesh mesh = parse_msh_text(text).mesh;
  CHECK(mesh.labels == std::vector<int>{11, 12, 13});
  CHECK(mesh.regions == std::vector<int>{0});  // a single one tells nothing apart
}

TEST_CASE("Of several time steps the last one is read", "[mesher][io][msh]") {
  std::string later = node_data;
  later.replace(later.find("40 4"), 4, "40 8");
  const MeshData data = parse_msh_text(format_4 + msh_nodes + elements + node_data + later);
  REQUIRE(data.fields.points.size() == 1);
  CHECK(data.fields.points[0].values == std::vector<double>{1, 2, 3, 8});
}

TEST_CASE("A field with values on a part of the mesh is left out, with a note", "[mesher][io][msh]") {
  using Catch::Contains;
  std::string partial = node_data;
  partial.replace(partial.find("4\n40 4\n"), 7, "3\n");
  partial.replace(partial.find("the u"), 5, "a part");
  const std::string on_line = "$ElementData\n1\n\"w\"\n0\n3\n0\n1\n1\n1 5\n$EndElementData\n";
  const MeshData read = parse_msh_text(format_4 + msh_nodes + elements + partial + node_data + on_line);
  REQUIRE(read.fields.points.size() == 1);
  CHECK(read.fields.points[0].name == "the u");
  CHECK(read.fields.cells.empty());
  REQUIRE(read.notes.size() == 2);
  CHECK_THAT(read.notes[0], Contains("'a part' is left out") && Contains("no value at node 40"));
  CHECK_THAT(read.notes[1], Contains("'w' is left out") && Contains("no value at triangle 3"));
}

TEST_CASE("Points of a geometry come back from Gmsh's format, from others' those in a group", "[mesher][io][msh]") {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh(3);
  mesh.triangles.clear();
  mesh.regions.clear();
  mesh.required = {};
  const Encoding encoding = GENERATE(Encoding::Text, Encoding::Binary);
  write_msh(folder / "g.msh", mesh, {}, encoding);
  const Mesh read = read_msh(folder / "g.msh").mesh;
  CHECK(read.points == mesh.points);
  CHECK(read.edges == mesh.edges);

  // Format 2: tag, type, 2 tags (group and entity), node; node 4 is a point that was named, node 5 the centre of an
  // arc.
  const auto num_points_with = [](const std::string& more) {
    return parse_msh_text(format_2 + "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0.2 0.2 0\n5 9 9 0\n$EndNodes\n" +
                          "$Elements\n" + more + "1 1 2 7 1 1 2\n2 1 2 7 1 2 3\n3 1 2 7 1 3 1\n4 15 2 8 4 4\n" +
                          "5 15 2 0 5 5\n$EndElements\n")
        .mesh.num_vertices();
  };
  CHECK(num_points_with("5\n") == 4);
  CHECK(num_points_with("6\n6 2 2 9 1 1 2 3\n") == 3);
}

TEST_CASE("Every fault in a Gmsh file is refused with its line", "[mesher][io][msh][errors]") {
  CHECK(msh_line_of("") == 1);
  CHECK(msh_line_of("# airfoil.msh geometry file\nmshid=1\n") == 2);
  CHECK(msh_line_of("$MeshFormat\n4.0 0 8\n$EndMeshFormat\n") == 2);
  CHECK(msh_line_of("$MeshFormat\n4.1 0 4\n$EndMeshFormat\n") == 2);
  CHECK(msh_line_of(format_4) == 3);
  CHECK(msh_line_of(format_4 + elements) == 4);
  CHECK(msh_line_of(format_4 + msh_nodes) == 19);
  CHECK(msh_line_of(format_4 + msh_nodes + msh_nodes + elements) == 20);
  CHECK(msh_line_of(format_4 + "$Nodes\n1 2 1 2\n2 1 0 2\n1\n1\n0 0 0\n1 0 0\n$EndNodes\n") == 10);  // a tag twice
  CHECK(msh_line_of(format_4 + "$Nodes\n1 1 1 1\n2 1 0 1\n1\n0 0 zero\n$EndNodes\n") == 8);
  CHECK(msh_line_of(format_4 + "$Nodes\n1 1 1 1\n2 1 0 -1\n") == 6);
  CHECK(msh_line_of(format_4 + "$Nodes\n1 99999999999999 1 1\n") == 5);
  CHECK(msh_line_of(format_4 + "$Nodes\n1 99999999999999999999 1 1\n") == 5);
  CHECK(msh_line_of(format_4 + msh_nodes + "$Elements\n1 1 1 1\n2 4 2 1\n1 10 20 31\n$EndElements\n") == 23);
  CHECK(msh_line_of(format_4 + msh_nodes + "$Elements\n1 1 1 1\n2 4 3 1\n1 10 20 30 40\n$EndElements\n") ==
        23);  // quads
  CHECK(msh_line_of(format_4 + msh_nodes + "$Elements\n1 1 1 1\n2 4 2 2\n1 10 20 30\n$EndElements\n") == 24);
  CHECK(msh_line_of(format_2 + "$PhysicalNames\n1\n1 7 wall\n$EndPhysicalNames\n") == 6);
  CHECK(msh_line_of(format_2 + "$PhysicalNames\n1\n1 7 \"Au\xdf"
                               "en\"\n$EndPhysicalNames\n") == 6);  // Latin-1
  CHECK(msh_line_of(format_4 + msh_nodes + elements + "$NodeData\n1\n\"u\"\n0\n3\n0\n2\n0\n$EndNodeData\n") == 36);
}

TEST_CASE("What a Gmsh file cannot mean here is refused", "[mesher][io][msh][errors]") {
  using Catch::Contains;
  const auto message_of = [](const std::string& text) { return error_message([&text] { parse_msh_text(text); }); };
  std::string raised = msh_nodes;
  raised.replace(raised.find("1 1 0\n0 1 0"), 5, "1 1 2");
  CHECK_THAT(message_of(format_4 + raised + elements), Contains("node 30") && Contains("plane"));
  const std::string vector =
      "$NodeData\n1\n\"v\"\n0\n3\n0\n3\n4\n10 1 2 0\n20 1 2 0\n30 1 2 3\n40 1 2 0\n$EndNodeData\n";
  CHECK_THAT(message_of(format_4 + msh_nodes + elements + vector), Contains("leaves the plane"));
  CHECK_THAT(message_of(format_2 + "$ParametricNodes\n1\n1 0 0 0 0 1\n$EndParametricNodes\n"),
             Contains("t.msh:4") && Contains("Mesh.SaveParametric"));
  const std::string overlap = "$Elements\n1 2 1 2\n2 4 2 2\n1 10 20 30\n2 10 20 40\n$EndElements\n";
  CHECK_THROWS_AS(parse_msh_text(format_4 + msh_nodes + overlap), parmesan::InputError);
}

TEST_CASE("A Gmsh file that is cut off within a section is refused", "[mesher][io][msh][errors]") {
  const std::string text = format_4 + names + entities + msh_nodes + elements;
  for (std::size_t length = 0; length < text.size() - 1; ++length) {
    CAPTURE(length);
    CHECK_THROWS_AS(parse_msh_text(text.substr(0, length)), FileError);
  }
  const TemporaryFolder folder;
  write_msh(folder / "m.msh", sample_mesh(2), {}, Encoding::Binary);
  const std::string bytes = content_of(folder / "m.msh");
  for (std::size_t length = 0; length < bytes.size() - 1; ++length) {
    CAPTURE(length);
    CHECK_THROWS_AS(parse_msh_text(bytes.substr(0, length)), FileError);
  }
}

TEST_CASE("A Gmsh file with any byte changed is read or refused", "[mesher][io][msh][errors]") {
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(1);
  write_msh(folder / "m.msh", mesh, sample_fields(mesh), GENERATE(Encoding::Text, Encoding::Binary));
  const std::string bytes = content_of(folder / "m.msh");
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const char c : {'\0', '\n', '9', '-', '\x7f', '\xff'}) {
      std::string changed = bytes;
      changed[i] = c;
      try {
        const MeshData data = parse_msh_text(changed);
        CHECK(data.mesh.regions.size() == data.mesh.triangles.size());
      } catch (const parmesan::InputError&) {
        SUCCEED();
      }
    }
  }
}

TEST_CASE("Fields of the wrong size are not written to Gmsh's format", "[mesher][io][msh][errors]") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(write_msh(folder / "m.msh", sample_mesh(2), {{{"u", 1, {1.0}}}, {}}), parmesan::InputError);
  MeshFields fields{{{"u", 1, std::vector<double>(9, std::numeric_limits<double>::quiet_NaN())}}, {}};
  CHECK_THROWS_AS(write_msh(folder / "m.msh", sample_mesh(2), fields, Encoding::Binary), FileError);
  CHECK(folder.num_files() == 0);
}

TEST_CASE("Labels of one name are one group of Gmsh's", "[mesher][io][msh]") {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh(2);
  mesh.label_names = {{1, "wall"}, {2, "gate"}, {3, "wall"}};
  mesh.region_names = {{7, "wall"}, {8, "wall"}};
  write_msh(folder / "a.msh", mesh, {});
  const std::string text = content_of(folder / "a.msh");
  const auto count = [&text](const std::string& name) {
    int found = 0;
    for (auto i = text.find(name); i != std::string::npos; i = text.find(name, i + 1)) ++found;
    return found;
  };
  CHECK(count("1 1 \"wall\"") == 1);
  CHECK(count("\"wall\"") == 2);  // lines, and triangles
  const Mesh read = read_msh(folder / "a.msh").mesh;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    CHECK(parmesan::label_name(read.label_names, read.labels[e]) ==
          parmesan::label_name(mesh.label_names, mesh.labels[e]));
}

TEST_CASE("Triangles of a Gmsh file that are turned one way and the other are told of", "[mesher][io][msh]") {
  const auto read = [](const std::string& first, const std::string& second) {
    return parse_msh_text(format_2 + "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n2\n" +
                          "1 2 2 5 1 " + first + "\n2 2 2 5 1 " + second + "\n$EndElements\n");
  };
  CHECK(read("1 2 3", "1 3 4").mesh_notes.empty());
  CHECK(read("1 3 2", "1 4 3").mesh_notes.empty());  // seen from below
  const std::vector<std::string> notes = read("1 2 3", "1 4 3").mesh_notes;
  REQUIRE(notes.size() == 1);
  CHECK(notes.front() == "turned 1 of 2 triangles, which are clockwise, others not; the first is triangle 2");
}
