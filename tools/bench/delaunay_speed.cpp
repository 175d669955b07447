// Delaunay and constrained Delaunay triangulation beside CGAL's, both with exact predicates:
//
//   delaunay_speed [POINTS [RUNS]]     1000000 points and 5 runs when they are not given
//
// The two take turns; the table has the medians of their processor times. To build it:
//
//   cmake -B build/release -DPARMESAN_BUILD_BENCHMARKS=ON && cmake --build build/release --target delaunay_speed
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesher/triangulation/delaunay.h"
#include "mesher/triangulation/triangulate.h"
#include "tools/bench/cgal_delaunay.h"
#include "tools/bench/point_sets.h"
#include "tools/bench/timing.h"

namespace parmesan::bench {
namespace {

constexpr auto count_vertices = [](const Triangulation& t) { return t.num_vertices(); };

Timing our_delaunay(const Domain& domain) {
  return time([&] { return std::move(delaunay(domain.points).triangulation); }, count_vertices);
}

Timing our_constrained(const Domain& domain) {
  return time([&] { return triangulate(domain); }, count_vertices);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

using Ours = Timing (*)(const Domain&);
using Cgals = std::optional<Timing> (*)(const Domain&);

/// One line of the table. Complains when the two do not have the same number of vertices.
void compare(const std::string& name, const Domain& domain, int runs, Ours ours, Cgals cgals) {
  std::vector<double> our_seconds;
  std::vector<double> cgal_seconds;
  for (int run = 0; run < runs; ++run) {
    const Timing our = ours(domain);
    const std::optional<Timing> cgal = cgals(domain);
    our_seconds.push_back(our.seconds);
    if (cgal) cgal_seconds.push_back(cgal->seconds);
    if (cgal && cgal->num_vertices != our.num_vertices)
      std::fprintf(stderr, "%s: %ld vertices, CGAL has %ld\n", name.c_str(), our.num_vertices, cgal->num_vertices);
  }
  const double our_median = median(our_seconds);
  std::printf("| %s | %.3f |", name.c_str(), our_median);
  if (cgal_seconds.empty()) {
    std::printf(" - | - |\n");
  } else {
    std::printf(" %.3f | %.2f |\n", median(cgal_seconds), our_median / median(cgal_seconds));
  }
  std::fflush(stdout);
}

void run(int num_points, int runs) {
  if (!cgal_delaunay({})) std::fprintf(stderr, "skipped CGAL: the program was built without it\n");
  std::printf("| %d points | parmesan, s | CGAL, s | ratio |\n|---|---:|---:|---:|\n", num_points);
  for (const PointSet& set : point_sets(num_points)) {
    Domain only_points;
    only_points.points = set.points;
    compare(set.name + ", Delaunay", only_points, runs, our_delaunay, cgal_delaunay);
    compare(set.name + ", constrained", with_segments(set.points), runs, our_constrained, cgal_constrained);
  }
}

}  // namespace
}  // namespace parmesan::bench

int main(int argc, char** argv) {
  const int num_points = argc > 1 ? std::atoi(argv[1]) : 1'000'000;
  const int runs = argc > 2 ? std::atoi(argv[2]) : 5;
  if (num_points < 3 || runs < 1) {
    std::fprintf(stderr, "usage: delaunay_speed [POINTS [RUNS]], at least 3 points and 1 run\n");
    return EXIT_FAILURE;
  }
  parmesan::bench::run(num_points, runs);
  return EXIT_SUCCESS;
}
