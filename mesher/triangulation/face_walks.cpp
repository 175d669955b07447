#include "mesher/triangulation/face_walks.h"

#include <deque>
#include <string>
#include <utility>

#include "mesher/errors.h"

namespace parmesan {

std::vector<std::vector<int>> segments_around(const Faces& faces) {
  std::vector<std::vector<int>> around(at(faces.count()));
  for (int s = 0; s < faces.num_segments(); ++s)
    for (const int face : faces.beside(s)) around[at(face)].push_back(s);
  return around;
}

// Faces with nothing counted between are reached first.
std::vector<int> layers_of(const Faces& faces, const std::function<bool(int)>& counts) {
  const std::vector<std::vector<int>> around = segments_around(faces);
  std::vector<int> layers(around.size(), -1);
  std::deque<std::pair<int, int>> reached{{0, 0}};  // faces and their layers
  while (!reached.empty()) {
    const auto [from, layer] = reached.front();
    reached.pop_front();
    if (layers[at(from)] >= 0) continue;
    layers[at(from)] = layer;
    for (const int s : around[at(from)]) {
      for (const int face : faces.beside(s)) {
        if (layers[at(face)] >= 0) continue;
        if (counts(s)) {
          reached.emplace_back(face, layer + 1);
        } else {
          reached.emplace_front(face, layer);
        }
      }
    }
  }
  return layers;
}

std::vector<char> faces_inside(const Domain& domain, const Faces& faces) {
  std::vector<char> inside;
  for (const int layer : layers_of(faces, [](int) { return true; }))
    inside.push_back(static_cast<char>(is_inside_layer(layer, domain.inside)));
  for (std::size_t i = 0; i < domain.holes.size(); ++i) {
    const int face = faces.at(domain.holes[i]);
    if (face == 0) throw GeometryError("hole seed " + std::to_string(i) + " lies outside", {static_cast<int>(i)});
    inside[at(face)] = 0;
  }
  return inside;
}

}  // namespace parmesan
