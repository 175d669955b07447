// Meshes the unit square uniformly: enough to see that parmesan::mesher links and works.
#include <mesher/generate.h>

#include <iostream>

int main() {
  parmesan::Domain square;
  square.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  square.segments = {{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 0, 4}};
  const auto result = parmesan::generate(square, parmesan::ConstantField(parmesan::Metric::isotropic(0.1)));
  std::cout << result.mesh.num_vertices() << " vertices\n";
  return result.mesh.num_vertices() > 80 && result.mesh.num_vertices() < 220 ? 0 : 1;
}
