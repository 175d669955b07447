#include "mesher/metric/tensor_interpolant.h"

#include <catch2/catch.hpp>
#include <random>

#include "mesher/errors.h"
#include "mesher/index.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

// Definite in one part of the square, indefinite in another.
SymmetricTensor linear_tensor(const Point& p) { return {p.x - 0.3, 2.0 * p.y, 0.5 - p.x - p.y}; }

std::vector<SymmetricTensor> sample(const Mesh& mesh) {
  std::vector<SymmetricTensor> tensors;
  for (const Point& p : mesh.points) tensors.push_back(linear_tensor(p));
  return tensors;
}

}  // namespace

TEST_CASE("TensorInterpolant reproduces tensors that vary linearly, whatever the hint", "[mesher][metric]") {
  const Mesh mesh = support::random_square(12, 0.2, 7);
  const TensorInterpolant field(mesh, sample(mesh));
  std::mt19937_64 engine(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::uniform_int_distribution<int> any(-1, mesh.num_triangles());
  for (int i = 0; i < 500; ++i) {
    const Point p{unit(engine), unit(engine)};
    MetricHint hint = any(engine);
    const SymmetricTensor found = field.at(p, hint);
    CHECK(found.xx == Approx(linear_tensor(p).xx).margin(1e-12));
    CHECK(found.xy == Approx(linear_tensor(p).xy).margin(1e-12));
    CHECK(found.yy == Approx(linear_tensor(p).yy).margin(1e-12));
  }
}

TEST_CASE("TensorInterpolant does not answer across a narrow gap", "[mesher][metric]") {
  // Two squares, the second beyond a gap a hundred thousand times as narrow.
  constexpr double gap = 1e-5;
  const Mesh left = support::rectangle_mesh(3, 3);
  Mesh both = left;
  for (const Point& p : left.points) both.points.push_back({p.x + 1.0 + gap, p.y});
  const int n = left.num_vertices();
  for (const auto& [a, b, c] : left.triangles) both.triangles.push_back({a + n, b + n, c + n});
  both.regions.resize(both.triangles.size(), 0);
  std::vector<SymmetricTensor> tensors(at(n), {1.0, 0.0, 1.0});
  tensors.resize(at(2 * n), {2.0, 0.0, 2.0});
  const TensorInterpolant field(both, tensors);
  for (double y = 0.0; y <= 1.0; y += 1.0 / 64.0) {
    MetricHint in_left = -1, in_right = -1;
    CHECK(field.at({0.9, y}, in_left).xx == Approx(1.0));
    CHECK(field.at({1.1, y}, in_right).xx == Approx(2.0));
    CHECK(field.at({1.0 + gap, y}, in_left).xx == Approx(2.0));
    CHECK(field.at({1.0, y}, in_right).xx == Approx(1.0));
  }
}

TEST_CASE("TensorInterpolant wants one tensor per vertex, and triangles", "[mesher][metric][errors]") {
  const Mesh mesh = support::rectangle_mesh(2, 2);
  CHECK_THROWS_WITH(TensorInterpolant(mesh, std::vector<SymmetricTensor>(3)),
                    Catch::Contains("9 vertices but 3 tensors"));
  CHECK_THROWS_AS(TensorInterpolant(Mesh{}, std::vector<SymmetricTensor>{}), InputError);
}

TEST_CASE("CallableTensorField asks its function", "[mesher][metric]") {
  MetricHint hint = -1;
  CHECK(CallableTensorField(linear_tensor).at({0.25, 0.5}, hint) == linear_tensor({0.25, 0.5}));
}
