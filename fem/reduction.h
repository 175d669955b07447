#pragma once

#include <span>
#include <vector>

#include "fem/assembly.h"

namespace parmesan {

/// The equations of the vertices that are not fixed, A_ff u_f = F_f - A_fd g_d.
struct ReducedMatrix {
  RowMatrix matrix;           // A_ff
  std::vector<int> vertices;  // vertex of each unknown, increasing
};

/// fixed: n flags. Cost: O(n).
ReducedMatrix reduced_matrix(const RowMatrix& matrix, std::span<const char> fixed);

/// The right-hand side F_f - A_fd g_d; given: n values, looked at where fixed. Cost: O(n).
Eigen::VectorXd reduced_load(const RowMatrix& matrix, const Eigen::VectorXd& load, std::span<const char> fixed,
                             std::span<const double> given);

}  // namespace parmesan
