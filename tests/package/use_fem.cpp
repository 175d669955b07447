// Solves Laplace's equation on two triangles with u = x on the boundary: the solution is x.
#include <fem/solve.h>

#include <cmath>
#include <iostream>

int main() {
  parmesan::Mesh mesh;
  mesh.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.5, 0.5}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  mesh.regions = {0, 0, 0, 0};
  mesh.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  mesh.labels = {1, 1, 1, 1};
  parmesan::Problem problem;
  problem.diffusion = [](const parmesan::Point&, int) { return parmesan::identity_tensor; };
  const auto x = [](const parmesan::Point& p, const parmesan::Vector&, int) { return p.x; };
  problem.boundary[1] = {parmesan::BoundaryKind::Dirichlet, x, {}};
  const double u = parmesan::solve(mesh, problem).values[4];
  std::cout << "u = " << u << "\n";
  return std::abs(u - 0.5) < 1e-12 ? 0 : 1;
}
