#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/parallel.h"

namespace parmesan {

/// What a triangle adds to the loads of its three vertices.
using TriangleLoad = std::array<double, 3>;

/// The sum of what local(t) gives for each triangle t; n values. On the threads of OpenMP, summed in the order of the
/// triangles: the same bits for any number of threads.
template <class F>
Eigen::VectorXd sum_of_loads(const Mesh& mesh, F local) {
  std::vector<TriangleLoad> loads(mesh.triangles.size());
  for_each_in_parallel(loads.size(), [&](std::size_t t) { loads[t] = local(t); });
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.num_vertices());
  for (std::size_t t = 0; t < loads.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) sum[mesh.triangles[t][i]] += loads[t][i];
  }
  return sum;
}

}  // namespace parmesan
