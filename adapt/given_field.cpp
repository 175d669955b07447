#include "adapt/given_field.h"

#include "fem/p1.h"
#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/index.h"
#include "mesher/mesh_walk.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

/// A given field with the place that was looked at last.
class Lookup {
 public:
  explicit Lookup(std::shared_ptr<const GivenField> field) : field_(std::move(field)), walk_(field_->mesh) {}

  double value(const Point& p) {
    const MeshPlace place = walk_.locate(p, triangle_);
    return p1_value(place.weights, values_at_corners(place.triangle));
  }

  Vector gradient(const Point& p) {
    const std::size_t triangle = walk_.locate(p, triangle_).triangle;
    return p1_gradient(p1_element(field_->mesh, static_cast<int>(triangle)), values_at_corners(triangle));
  }

 private:
  std::array<double, 3> values_at_corners(std::size_t triangle) const {
    return at_corners<double>(field_->mesh, triangle, field_->values);
  }

  std::shared_ptr<const GivenField> field_;
  MeshWalk walk_;
  std::size_t triangle_ = 0;
};

}  // namespace

ExactFunction function_of(const std::shared_ptr<const GivenField>& field) {
  const auto lookup = std::make_shared<Lookup>(field);
  return {[lookup](const Point& p) { return lookup->value(p); },
          [lookup](const Point& p) { return lookup->gradient(p); }};
}

std::optional<std::string> warn_beyond(const GivenField& field, const Mesh& mesh) {
  constexpr double much = 1e-3;
  const MeshWalk walk(field.mesh);
  std::size_t triangle = 0;
  double farthest = 0.0;
  Point where;
  for (const Point& p : mesh.points) {
    const MeshPlace place = walk.locate(p, triangle);
    Point nearest;
    for (std::size_t k = 0; k < 3; ++k)
      nearest = nearest + place.weights[k] * field.mesh.points[at(field.mesh.triangles[place.triangle][k])];
    if (norm(p - nearest) <= farthest) continue;
    farthest = norm(p - nearest);
    where = p;
  }
  if (farthest <= much * bounding_diagonal(field.mesh.points)) return std::nullopt;
  return "the domain reaches beyond the mesh of the given function, by about " + text(farthest, 2) + " at " +
         text(where, 4) +
         ": there the function goes on with the value of the nearest place, which meshes are not adapted to";
}

}  // namespace parmesan
