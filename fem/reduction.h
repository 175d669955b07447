#pragma once

#include <vector>

#include "fem/assembly.h"
#include "fem/boundary_conditions.h"

namespace parmesan {

/// The equations of the vertices that are not fixed, A_ff u_f = F_f - A_fd g_d.
struct ReducedSystem {
  RowMatrix matrix;
  Eigen::VectorXd load;
  std::vector<int> vertices;  // vertex of each unknown, increasing
};

/// Cost: O(n).
ReducedSystem reduce(const AssembledSystem& system, const FixedVertices& fixed);

}  // namespace parmesan
