#include "mesher/mesh.h"

#include <algorithm>
#include <utility>

#include "mesher/index.h"

namespace parmesan {

std::vector<int> ascending(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

double area(const Mesh& mesh) {
  double doubled = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    doubled += doubled_area(mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)]);
  return 0.5 * doubled;
}

std::vector<int> ends_of_edges(const Mesh& mesh) {
  std::vector<int> ends;
  ends.reserve(2 * mesh.edges.size());
  for (const auto& edge : mesh.edges) ends.insert(ends.end(), edge.begin(), edge.end());
  return ascending(std::move(ends));
}

std::string label_name(const LabelNames& names, int label) {
  const auto found = names.find(label);
  return found == names.end() ? std::to_string(label) : found->second;
}

}  // namespace parmesan
