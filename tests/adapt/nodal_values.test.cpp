#include "adapt/nodal_values.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/norms.h"
#include "mesher/generate.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

// sqrt(r) cos(theta/2), theta from 0 above the positive x axis to 2 pi below it.
double jumping(const Point& p) { return -std::sqrt(norm(p)) * std::sin(0.5 * std::atan2(-p.y, -p.x)); }

}  // namespace

TEST_CASE("nodal_values are those of the function where there are no cracks", "[adapt]") {
  const Mesh mesh = support::rectangle_mesh(3, 3);
  CHECK(nodal_values(mesh, jumping) == interpolate(mesh, jumping));
}

TEST_CASE("nodal_values differ on the sides of a crack as the function does", "[adapt]") {
  Domain domain;
  support::add_polygon(domain, {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}, 1);
  domain.points.insert(domain.points.end(), {{0.0, 0.0}, {1.0, 0.0}});
  domain.segments.push_back({4, 5, 7, 8});
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(0.1))).mesh;
  const std::vector<double> values = nodal_values(mesh, jumping);
  int checked = 0;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    if (mesh.labels[e] != 7 && mesh.labels[e] != 8) continue;
    for (const int vertex : mesh.edges[e]) {
      const auto v = static_cast<std::size_t>(vertex);
      const double expected = (mesh.labels[e] == 7 ? 1.0 : -1.0) * std::sqrt(mesh.points[v].x);
      CHECK(values[v] == Approx(expected).epsilon(1e-6).margin(1e-15));
      ++checked;
    }
  }
  CHECK(checked >= 36);
}
