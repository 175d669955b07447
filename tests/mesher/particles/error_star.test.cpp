#include "mesher/particles/error_star.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "mesher/triangulation/conversion.h"
#include "tests/oracle/interpolation_error.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

// A disordered square of 4 x 4 cells, the vertex at its middle, and a Hessian per vertex.
struct Middle {
  explicit Middle(SymmetricTensor (*hessian)(const Point&)) {
    mesh = support::random_square(4, 0.2, 2);
    const Domain domain = support::unit_square();
    const ConstantField field(Metric::isotropic(0.25));
    const ParticleSystem particles(from_mesh(mesh, support::segments_of(mesh)), domain, field);
    std::vector<SymmetricTensor> hessians;
    for (const Point& p : mesh.points) hessians.push_back(hessian(p));
    star.gather(particles, hessians, vertex);
    place = mesh.points[static_cast<std::size_t>(vertex)];
  }

  Mesh mesh;
  VertexId vertex = 2 * 5 + 2;
  Point place;
  ErrorStar star;
};

}  // namespace

TEST_CASE("the error of a star is that of its triangles' interpolant", "[mesher][particles]") {
  const auto saddle = [](const Point&) { return SymmetricTensor{2.0, 0.5, -3.0}; };
  const Middle middle(saddle);
  Mesh around = middle.mesh;
  std::erase_if(around.triangles, [&](const auto& t) { return std::ranges::find(t, middle.vertex) == t.end(); });
  CHECK(middle.star.squared_error(middle.place, saddle({})) ==
        Approx(oracle::squared_interpolation_error(around, [](const Point& p) {
          return p.x * p.x + 0.5 * p.x * p.y - 1.5 * p.y * p.y;
        })).epsilon(1e-10));
}

TEST_CASE("in each triangle of a star the Hessian is the mean of its vertices'", "[mesher][particles]") {
  // Where it varies linearly that is the Hessian at the centroid.
  const auto hessian = [](const Point& p) { return SymmetricTensor{1.0 + 4.0 * p.x, p.x - p.y, 2.0 - 3.0 * p.y}; };
  const Middle middle(hessian);
  double sum = 0.0;
  for (const auto& t : middle.mesh.triangles) {
    if (std::ranges::find(t, middle.vertex) == t.end()) continue;
    const Point& a = middle.mesh.points[static_cast<std::size_t>(t[0])];
    const Point& b = middle.mesh.points[static_cast<std::size_t>(t[1])];
    const Point& c = middle.mesh.points[static_cast<std::size_t>(t[2])];
    const SymmetricTensor h = hessian((1.0 / 3.0) * (a + b + c));
    sum += oracle::squared_interpolation_error(a, b, c, [h](const Point& p) { return 0.5 * quadratic_form(h, p); });
  }
  CHECK(middle.star.squared_error(middle.place, hessian(middle.place)) == Approx(sum).epsilon(1e-10));
}

TEST_CASE("the gradient of a star's error follows a Hessian that varies linearly", "[mesher][particles]") {
  const auto hessian = [](const Point& p) { return SymmetricTensor{1.0 + 4.0 * p.x, p.x - p.y, 2.0 - 3.0 * p.y}; };
  const Middle middle(hessian);
  const ErrorJet jet = middle.star.jet(middle.place, hessian(middle.place));
  const double d = 1e-5;
  const auto difference = [&](const Vector& step) {
    const Point ahead = middle.place + step, behind = middle.place - step;
    return (middle.star.squared_error(ahead, hessian(ahead)) - middle.star.squared_error(behind, hessian(behind))) /
           (2.0 * norm(step));
  };
  CHECK(jet.gradient.x == Approx(difference({d, 0.0})).epsilon(1e-6));
  CHECK(jet.gradient.y == Approx(difference({0.0, d})).epsilon(1e-6));
}
