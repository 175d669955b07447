#include "fem/load.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/geometry/point.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

/// The integral over a triangle of F''(s), s linear with these values at the corners: 2 area F[s0, s1, s2], a divided
/// difference (Hermite and Genocchi).
double integral_of_second_derivative(double area, const std::array<double, 3>& s, double (*F)(double)) {
  const double d01 = (F(s[1]) - F(s[0])) / (s[1] - s[0]);
  const double d12 = (F(s[2]) - F(s[1])) / (s[2] - s[1]);
  return 2 * area * (d12 - d01) / (s[2] - s[0]);
}

}  // namespace

TEST_CASE("a source far thinner than the triangles is integrated in each of them", "[fem][load]") {
  // f = -d2/ds2 atan(1000 s): a positive and a negative crest, each 1/1000 wide, in triangles of size 1/64.
  const double steepness = 1000;
  const auto s = [](const Point& p) { return 0.6 * p.x + 0.8 * p.y - 0.7001; };
  Problem problem;
  problem.source = [&](const Point& p, int) {
    const double t = steepness * s(p);
    return 2 * steepness * steepness * t / ((1 + t * t) * (1 + t * t));
  };
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const Mesh mesh = random_square(64, 0.2, seed);
    const std::vector<SourceMoments> moments = source_moments(mesh, problem);
    double error = 0.0, magnitude = 0.0, largest = 0.0;
    for (std::size_t t = 0; t < moments.size(); ++t) {
      const std::array<int, 3>& v = mesh.triangles[t];
      const auto corner = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(v[i])]; };
      const double area = 0.5 * doubled_area(corner(0), corner(1), corner(2));
      const double exact = integral_of_second_derivative(area, {s(corner(0)), s(corner(1)), s(corner(2))},
                                                         [](double x) { return -std::atan(1000 * x); });
      const double difference = std::abs(moments[t][0] + moments[t][1] + moments[t][2] - exact);
      error += difference;
      magnitude += std::abs(exact);
      largest = std::max(largest, difference);
    }
    INFO("seed " << seed << ", largest error " << largest);
    CHECK(error < 2e-3 * magnitude);
  }
}

TEST_CASE("a source that is noise costs a bounded number of points", "[fem][load]") {
  // What is left of terms that cancel: no subdivision ever confirms another.
  long calls = 0;
  Problem problem;
  problem.source = [&calls](const Point& p, int) {
    ++calls;
    return std::fmod(1e6 * std::sin(1e9 * p.x + 1e8 * p.y), 1.0);
  };
  source_moments(rectangle_mesh(40, 40), problem);
  CHECK(calls < 3'000'000);
}

}  // namespace parmesan
