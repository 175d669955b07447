#include "mesher/io/picture/labelled_edges.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/support/meshes.h"

using namespace parmesan;

TEST_CASE("labelled edges are there once, each label in a colour of its own", "[mesher][io][picture]") {
  Mesh mesh = support::rectangle_mesh(4, 3);
  mesh.label_names[mesh.labels[0]] = "a side";
  const View view{bounds_of(mesh), 100.0, {0.0, 300.0}};
  const std::vector<LabelledEdges> edges = labelled_edges(mesh, view);
  const std::set<int> labels(mesh.labels.begin(), mesh.labels.end());
  REQUIRE(edges.size() == labels.size());
  std::set<std::string> colours, names;
  std::size_t steps = 0;
  for (const LabelledEdges& of_label : edges) {
    colours.insert(of_label.colour);
    names.insert(of_label.name);
    steps += of_label.path.steps().size();
  }
  CHECK(colours.size() == edges.size());
  CHECK(names.contains("a side"));
  CHECK(steps == 2 * mesh.edges.size());
}

TEST_CASE("a legend gets more rows where the picture is narrow", "[mesher][io][picture]") {
  std::vector<LabelledEdges> edges;
  CHECK(legend_height(edges, 500.0) == 0.0);
  for (int i = 0; i < 6; ++i) edges.push_back({"a side with a name", "#000000", {}});
  const double one_row = legend_height({edges[0]}, 500.0);
  CHECK(legend_height(edges, 2000.0) == one_row);
  CHECK(legend_height(edges, 400.0) >= 2.0 * one_row);
  CHECK(legend_height(edges, 10.0) == 6.0 * one_row);
}
