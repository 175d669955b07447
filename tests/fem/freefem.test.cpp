#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>

#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;
namespace fs = std::filesystem;

bool has_freefem() { return std::system("command -v FreeFem++ >/dev/null 2>&1") == 0; }

/// FreeFEM's own format, all numbers from 1.
void write_mesh(const Mesh& mesh, const fs::path& path) {
  std::ofstream out(path);
  out << std::setprecision(17) << mesh.num_vertices() << " " << mesh.num_triangles() << " " << mesh.num_edges() << "\n";
  for (const Point& p : mesh.points) out << p.x << " " << p.y << " 0\n";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t]) out << v + 1 << " ";
    out << mesh.regions[t] << "\n";
  }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    out << mesh.edges[e][0] + 1 << " " << mesh.edges[e][1] + 1 << " " << mesh.labels[e] << "\n";
  }
}

std::vector<double> freefem_solution(const Mesh& mesh) {
  std::string pattern = (fs::temp_directory_path() / "parmesan_freefem_XXXXXX").string();
  REQUIRE(mkdtemp(pattern.data()) != nullptr);
  const fs::path folder = pattern;
  write_mesh(mesh, folder / "mesh.msh");
  const std::string command = "FreeFem++ -nw -v 0 " PARMESAN_SOURCE_DIR "/tests/fem/freefem.edp " + folder.string() +
                              " >" + (folder / "log").string() + " 2>&1";
  const int status = std::system(command.c_str());
  std::ifstream in(folder / "values.txt");
  std::vector<double> values;
  for (double value = 0.0; in >> value;) values.push_back(value);
  fs::remove_all(folder);
  REQUIRE(status == 0);
  return values;
}

/// The problem of freefem.edp. Polynomial data, so that both integrate exactly.
Problem freefem_problem() {
  Problem problem;
  problem.diffusion = [](const Point&, int region) {
    const double k = region == 2 ? 10.0 : 1.0;
    return Diffusion{2 * k, 0.5 * k, k};
  };
  problem.velocity = [](const Point&, int) { return Vector{1, -2}; };
  problem.reaction = [](const Point&, int) { return 3.0; };
  problem.source = [](const Point& p, int) { return 1 + p.x; };
  problem.stabilize = false;
  const auto given = dirichlet([](const Point& p, const Vector&, int) { return p.x + p.y * p.y; });
  problem.boundary = {{Bottom, given},
                      {Left, given},
                      {Right, neumann([](const Point&, const Vector&, int) { return 0.5; })},
                      {Top, robin([](const Point&, const Vector&, int) { return 2.0; },
                                  [](const Point& p, const Vector&, int) { return p.y; })}};
  return problem;
}

}  // namespace

TEST_CASE("the P1 solution is FreeFEM's on the same mesh", "[fem][solve][freefem]") {
  if (!has_freefem()) {
    WARN("skipped: there is no FreeFem++ (Debian package freefem++)");
    return;
  }
  Mesh mesh = GENERATE(random_square(14, 0.24, 21), stretched_square(12));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Point& p = mesh.points[static_cast<std::size_t>(mesh.triangles[t][0])];
    mesh.regions[t] = p.x + p.y < 0.9 ? 1 : 2;
  }
  const std::vector<double> theirs = freefem_solution(mesh);
  const std::vector<double> ours = solve(mesh, freefem_problem()).values;
  REQUIRE(theirs.size() == ours.size());
  double largest = 0.0;
  for (std::size_t v = 0; v < ours.size(); ++v) largest = std::max(largest, std::abs(ours[v] - theirs[v]));
  CHECK(largest < 1e-10);
}

}  // namespace parmesan
