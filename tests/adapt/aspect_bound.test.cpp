#include "adapt/aspect_bound.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace parmesan;

namespace {

/// Places with second derivatives (l1, l2), l1 from 1 to exp(spread), turned at random, and an influence.
struct Places {
  std::vector<Eigen2> hessians;
  std::vector<double> areas;
  std::vector<SymmetricTensor> influence;
};

Places some_places(int count, double l2, double spread, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Places places;
  for (int i = 0; i < count; ++i) {
    const double angle = 7.0 * uniform(random);
    const Vector axis{std::cos(angle), std::sin(angle)};
    places.hessians.push_back({std::exp(spread * uniform(random)), l2, axis});
    places.areas.push_back(0.1 + uniform(random));
    // Large across, which must not matter.
    places.influence.push_back(compose({1e3, std::exp(-5.0 * uniform(random)), axis}));
  }
  return places;
}

double along(const Places& places, std::size_t v) {
  const Vector& n = places.hessians[v].axis;
  return quadratic_form(places.influence[v], {-n.y, n.x});
}

/// int E^2 + c (int s A^2 E)^2, where A E, the second derivative times the area of a triangle, is given.
double total_error(const Places& places, const std::vector<double>& work, const std::vector<double>& aspects,
                   double c) {
  double squares = 0.0, mean = 0.0;
  for (std::size_t v = 0; v < aspects.size(); ++v) {
    const double error = work[v] / aspects[v];
    squares += places.areas[v] * error * error;
    mean += places.areas[v] * along(places, v) * aspects[v] * aspects[v] * error;
  }
  return squares + c * mean * mean;
}

}  // namespace

TEST_CASE("no other aspects have a smaller error of a Galerkin solution", "[adapt][aspect]") {
  const double norm = GENERATE(1.0, 2.0, 4.0);
  const Places places = some_places(40, 1e-12, 6.0, 1);
  const std::vector<double> bounds = aspect_bounds(places.hessians, places.areas, places.influence, norm);
  std::vector<double> work(bounds.size());
  double mean = 0.0;
  for (std::size_t v = 0; v < bounds.size(); ++v) {
    const double error = std::pow(places.hessians[v].l1 / bounds[v], 1.0 / (norm + 1.0));
    work[v] = error * bounds[v];
    mean += places.areas[v] * along(places, v) * bounds[v] * bounds[v] * error;
  }
  int free = 0;
  double c = 0.0;  // the one that the first free place stands for
  for (std::size_t v = 0; v < bounds.size(); ++v) {
    if (bounds[v] <= 1.0) continue;
    if (++free == 1) c = work[v] / (std::pow(bounds[v], 3) * along(places, v) * mean);
    for (const double factor : {0.9, 1.1}) {
      std::vector<double> other = bounds;
      other[v] *= factor;
      CHECK(total_error(places, work, other, c) > total_error(places, work, bounds, c));
    }
  }
  CHECK(free > 20);
}

TEST_CASE("where all is alike the bound is 1.7 over the root of the influence", "[adapt][aspect]") {
  const double norm = GENERATE(1.0, 2.0, std::numeric_limits<double>::infinity());
  const std::vector<Eigen2> hessians(5, {3e4, 1e-9, {1, 0}});
  const std::vector<SymmetricTensor> influence(5, {0, 0, 0.1});
  for (const double bound : aspect_bounds(hessians, std::vector<double>(5, 2.0), influence, norm))
    CHECK(bound == Approx(1.7 / std::sqrt(0.1)).epsilon(2e-3));
}

TEST_CASE("bounds follow neither the unit of the function nor that of length, and are at least 1", "[adapt][aspect]") {
  Places places = some_places(30, 0.01, 60.0, 2);
  const std::vector<double> bounds = aspect_bounds(places.hessians, places.areas, places.influence, 2.0);
  for (Eigen2& e : places.hessians) e = {1e8 * e.l1, 1e8 * e.l2, e.axis};
  for (double& area : places.areas) area *= 1e-6;
  const std::vector<double> scaled = aspect_bounds(places.hessians, places.areas, places.influence, 2.0);
  for (std::size_t v = 0; v < bounds.size(); ++v) {
    CHECK(bounds[v] >= 1.0);
    CHECK(scaled[v] == Approx(bounds[v]).epsilon(1e-9));
  }
}

TEST_CASE("where nothing is felt aspects are not bounded", "[adapt][aspect]") {
  const std::vector<Eigen2> hessians(3, {1, 1e-9, {1, 0}});
  const std::vector<double> areas(3, 1.0);
  const std::vector<SymmetricTensor> influence{{0, 0, 0.5}, {0, 0, 0}, {0.5, 0, 0}};  // the last one across only
  const std::vector<double> bounds = aspect_bounds(hessians, areas, influence, 2.0);
  CHECK(bounds[0] < 10.0);
  CHECK(bounds[1] > 1e4);
  CHECK(bounds[2] > 1e4);
}
