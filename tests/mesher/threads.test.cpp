#include <omp.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesher/generate.h"
#include "mesher/metric/background_mesh.h"
#include "mesher/parallel.h"
#include "mesher/particles/blocks.h"
#include "mesher/triangulation/conversion.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

/// Sets the number of threads for a scope. The tests go downwards: LLVM's OpenMP loses a few hundred bytes of its own
/// each time that a team grows again, which the leak sanitizer takes for ours.
class Threads {
 public:
  explicit Threads(int n) : before_(omp_get_max_threads()) { omp_set_num_threads(n); }
  ~Threads() { omp_set_num_threads(before_); }

 private:
  int before_;
};

Metric ring_metric(const Point& p) {
  const double r = norm(p - Point{0.5, 0.5});
  const double across = 0.0015 + 0.04 * std::abs(r - 0.3);
  return Metric::from_sizes(across, 4.0 * across, std::atan2(p.y - 0.5, p.x - 0.5));
}

std::vector<Metric> ring_on(const Mesh& mesh) {
  std::vector<Metric> metrics;
  for (const Point& p : mesh.points) metrics.push_back(ring_metric(p));
  return metrics;
}

}  // namespace

TEST_CASE("any number of threads makes the same mesh", "[mesher][threads]") {
  const Domain domain = support::unit_square();
  const auto remeshed = [&](int threads) {
    const Threads scope(threads);
    const Mesh first = generate(domain, CallableField(ring_metric)).mesh;
    return generate(domain, BackgroundMesh(first, ring_on(first)), {}, first).mesh;
  };
  const Mesh one = remeshed(1);
  REQUIRE(one.num_vertices() > 10000);
  for (const int threads : {8, 4, 3, 2}) {
    CAPTURE(threads);
    const Mesh many = remeshed(threads);
    CHECK((many.points == one.points));
    CHECK((many.triangles == one.triangles));
  }
}

// Over two edges would do without the rule for the territory: a particle two edges away across its border does not
// move, since its neighbour is on this side. Over a radius of three it is needed.
TEST_CASE("any number of threads makes the same mesh where particles act from afar", "[mesher][threads]") {
  const Domain domain = support::unit_square();
  GenerateOptions options{.preset = Preset::Fast};
  options.particles.neighbourhood = GENERATE(Neighbourhood::N2, Neighbourhood::Radius);
  options.particles.radius = 3.0;
  const auto meshed = [&](int threads) {
    const Threads scope(threads);
    return generate(domain, CallableField(ring_metric), options).mesh;
  };
  const Mesh many = meshed(4);
  const Mesh one = meshed(1);
  REQUIRE(one.num_vertices() > 10000);
  CHECK((many.points == one.points));
  CHECK((many.triangles == one.triangles));
}

TEST_CASE("what fails first in number is thrown, on any number of threads", "[mesher][threads][errors]") {
  for (const int threads : {4, 2, 1}) {
    const Threads scope(threads);
    try {
      parallel_for(100, [](int i) {
        if (i % 10 == 7) throw std::runtime_error(std::to_string(i));
      });
      FAIL("nothing was thrown");
    } catch (const std::runtime_error& e) {
      CHECK(std::string(e.what()) == "7");
    }
  }
}

TEST_CASE("each cut has every particle once, in the territory of its block", "[mesher][threads]") {
  const Domain domain = support::unit_square();
  const CallableField field(ring_metric);
  const Mesh mesh = generate(domain, field).mesh;
  const ParticleSystem particles(from_mesh(mesh, support::segments_of(mesh)), domain, field);
  const Blocks blocks(particles);
  REQUIRE(mesh.num_vertices() > 10000);
  for (const int number : {0, 1}) {
    std::vector<int> times(static_cast<std::size_t>(particles.mesh().num_slots()), 0);
    const std::vector<Block> cut = blocks.cut(number);
    CHECK(cut.size() > 1);
    for (const Block& block : cut) {
      for (const VertexId v : block.particles) {
        ++times[static_cast<std::size_t>(v)];
        CHECK(block.territory.contains(particles, v));
      }
    }
    CHECK(times == std::vector<int>(times.size(), 1));
  }
}
