#pragma once

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "mesher/geometry/point.h"
#include "mesher/index.h"

namespace parmesan {

/// Names of integer labels; a label without an entry is called by its number.
using LabelNames = std::map<int, std::string>;

/// The lowest number of a region: the two below it tell faces apart while a domain is triangulated.
inline constexpr int min_region = std::numeric_limits<int>::min() + 2;

/// What of a mesh a remeshing leaves as it is, by ascending numbers.
struct RequiredParts {
  std::vector<int> vertices;   // stay where they are
  std::vector<int> edges;      // of Mesh::edges: stay whole
  std::vector<int> triangles;  // stay, with their corners and sides

  bool operator==(const RequiredParts&) const = default;
};

/// The numbers in ascending order, each once.
std::vector<int> ascending(std::vector<int> numbers);

/// A triangle mesh as plain arrays, which mesher, fem and adapt hand to each other.
///
/// Shape: points 2 x n; triangles 3 x m, counter-clockwise, with one region each;
/// edges 2 x b with one label each. Edges are the boundary edges, the domain to their left,
/// and the interior constraints. All indices start at 0.
struct Mesh {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> regions;
  std::vector<std::array<int, 2>> edges;
  std::vector<int> labels;
  LabelNames label_names;
  LabelNames region_names;
  RequiredParts required = {};
  int first_number = 0;  // that the user's file gives its points, triangles and edges, for messages

  int num_vertices() const { return static_cast<int>(points.size()); }
  int num_triangles() const { return static_cast<int>(triangles.size()); }
  int num_edges() const { return static_cast<int>(edges.size()); }
};

/// Sum of the areas of the triangles. Units: L^2.
double area(const Mesh& mesh);

/// The vertices that edges end at, ascending.
std::vector<int> ends_of_edges(const Mesh& mesh);

/// What messages call a point, a triangle or an edge of the mesh that the user gave.
inline std::string number_text(const Mesh& mesh, int index) { return std::to_string(index + mesh.first_number); }

/// The name of a label, or its number in decimal.
std::string label_name(const LabelNames& names, int label);

}  // namespace parmesan
