#include "adapt/transfer.h"

#include "fem/p1.h"
#include "mesher/errors.h"
#include "mesher/mesh_walk.h"

namespace parmesan {

std::vector<double> transfer(const Mesh& from, std::span<const double> values, const Mesh& to) {
  if (values.size() != from.points.size()) throw InputError("transfer needs one value per vertex");
  if (from.triangles.empty()) throw InputError("transfer needs a mesh with triangles");
  const MeshWalk walk(from);
  std::size_t triangle = 0;
  std::vector<double> result;
  result.reserve(to.points.size());
  for (const Point& p : to.points) {
    const MeshPlace place = walk.locate(p, triangle);
    result.push_back(p1_value(place.weights, at_corners(from, place.triangle, values)));
  }
  return result;
}

}  // namespace parmesan
