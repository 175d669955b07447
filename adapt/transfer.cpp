#include "adapt/transfer.h"

#include <cstddef>

#include "mesher/errors.h"
#include "mesher/mesh_walk.h"

namespace parmesan {

std::vector<double> transfer(const Mesh& from, std::span<const double> values, const Mesh& to) {
  if (values.size() != from.points.size()) throw InputError("transfer needs one value per vertex");
  if (from.triangles.empty()) throw InputError("transfer needs a mesh with triangles");
  MeshWalk walk(from);
  std::vector<double> result;
  result.reserve(to.points.size());
  for (const Point& p : to.points) {
    const MeshPlace place = walk.locate(p);
    double value = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      value += place.weights[k] * values[static_cast<std::size_t>(from.triangles[place.triangle][k])];
    result.push_back(value);
  }
  return result;
}

}  // namespace parmesan
