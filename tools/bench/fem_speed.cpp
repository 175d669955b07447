// Assembly and solution by size: processor time, memory and backward error of the method that solve() chooses.
//
//   fem_speed [LARGEST [MODEL]]     sizes up to LARGEST unknowns (default 1000000); MODEL 0 to 3, all when not given
//
// To build it: cmake -B build/release -DPARMESAN_BUILD_BENCHMARKS=ON && cmake --build build/release --target fem_speed
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>

#include "fem/assembly.h"
#include "fem/solve.h"

namespace parmesan::bench {
namespace {

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The largest resident set so far, in MiB.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// The unit square in cells x cells bent squares of two triangles; all of its boundary has label 1.
Mesh bent_square(int cells) {
  Mesh mesh;
  const auto id = [cells](int i, int j) { return j * (cells + 1) + i; };
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const Point p{static_cast<double>(i) / cells, static_cast<double>(j) / cells};
      const double s = 0.06 * std::sin(2 * std::numbers::pi * p.x) * std::sin(2 * std::numbers::pi * p.y);
      mesh.points.push_back({p.x + s, p.y - 0.8 * s});
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  for (int k = 0; k < cells; ++k) {
    mesh.edges.push_back({id(k, 0), id(k + 1, 0)});
    mesh.edges.push_back({id(cells, k), id(cells, k + 1)});
    mesh.edges.push_back({id(k + 1, cells), id(k, cells)});
    mesh.edges.push_back({id(0, k + 1), id(0, k)});
  }
  mesh.regions.assign(mesh.triangles.size(), 0);
  mesh.labels.assign(mesh.edges.size(), 1);
  return mesh;
}

struct Model {
  const char* name;
  double speed = 0.0;  // of the flow
  double reaction = 0.0;
};

Problem problem_of(const Model& model) {
  Problem problem;
  problem.source = [](const Point& p, int) { return std::sin(3 * p.x) * p.y; };
  if (model.speed > 0) problem.velocity = [s = model.speed](const Point&, int) { return Vector{s, 0.5 * s}; };
  if (model.reaction != 0) problem.reaction = [c = model.reaction](const Point&, int) { return c; };
  problem.boundary[1] = {};  // u = 0
  return problem;
}

void measure(const Model& model, int cells) {
  const Mesh mesh = bent_square(cells);
  const Problem problem = problem_of(model);
  const double start = processor_seconds();
  assemble(mesh, problem);
  const double assembled = processor_seconds();
  const SolveReport report = solve(mesh, problem).report;
  std::printf("| %s | %d | %s | %d | %.2f | %.2f | %.0f | %.1e |\n", model.name, report.unknowns, report.solver.c_str(),
              report.iterations, assembled - start, processor_seconds() - assembled, peak_memory(),
              report.backward_error);
  std::fflush(stdout);
}

constexpr std::array<Model, 4> Models{
    {{"Poisson", 0, 0}, {"reaction -60", 0, -60}, {"flow, speed 1", 1, 0}, {"flow, speed 10 000", 1e4, 0}}};

void measure_sizes(const Model& model, int largest) {
  for (int cells = 32; cells * cells <= 1.05 * largest; cells *= 2) measure(model, cells);
}

}  // namespace
}  // namespace parmesan::bench

int main(int argc, char** argv) {
  using namespace parmesan::bench;
  const int largest = argc > 1 ? std::atoi(argv[1]) : 1'000'000;
  std::printf(
      "| problem | unknowns | method | iterations | assembly s | assembly and solution s | peak MiB so far | "
      "backward error |\n|---|---:|---|---:|---:|---:|---:|---:|\n");
  if (argc > 2) {
    measure_sizes(Models.at(static_cast<std::size_t>(std::atoi(argv[2]))), largest);
  } else {
    for (const Model& model : Models) measure_sizes(model, largest);
  }
  return 0;
}
