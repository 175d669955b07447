#include "mesher/doubled_sides.h"

#include <array>

#include "mesher/index.h"
#include "mesher/number_text.h"
#include "mesher/seams.h"

namespace parmesan {
namespace {

std::string sides_text(const Mesh& mesh, const std::vector<std::array<int, 2>>& sides) {
  const bool is_one = sides.size() == 1;
  const auto& [a, b] = sides.front();
  return std::to_string(sides.size()) + (is_one ? " pair" : " pairs") + " of sides without a label, " +
         (is_one ? "" : "the first ") + "from " + text(mesh.points[at(a)]) + " to " + text(mesh.points[at(b)]) +
         ", with vertices of their own at the same places";
}

}  // namespace

std::vector<std::string> notes_on_doubled_sides(const ClosedMesh& closed) {
  std::vector<std::string> notes;
  if (!closed.seams.empty())
    notes.push_back(sides_text(closed.mesh, closed.seams) +
                    ": the parts of the mesh count as joined there; with labels they are the sides of a crack");
  std::vector<std::array<int, 2>> cracks;
  for (std::size_t e = 0; e < closed.mesh.edges.size(); ++e)
    if (closed.mesh.labels[e] == no_label && closed.right_labels[e] == no_label) cracks.push_back(closed.mesh.edges[e]);
  if (!cracks.empty()) notes.push_back(sides_text(closed.mesh, cracks) + ": they count as a crack");
  return notes;
}

}  // namespace parmesan
