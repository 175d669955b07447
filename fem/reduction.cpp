#include "fem/reduction.h"

#include <algorithm>

namespace parmesan {

ReducedMatrix reduced_matrix(const RowMatrix& matrix, std::span<const char> fixed) {
  ReducedMatrix result;
  std::vector<int> unknown(fixed.size(), -1);
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v]) continue;
    unknown[v] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(static_cast<int>(v));
  }
  const auto n = static_cast<Eigen::Index>(result.vertices.size());
  result.matrix.resize(n, n);
  result.matrix.reserve(matrix.nonZeros());
  for (Eigen::Index i = 0; i < n; ++i) {
    result.matrix.startVec(i);
    for (RowMatrix::InnerIterator a(matrix, result.vertices[static_cast<std::size_t>(i)]); a; ++a) {
      const int column = unknown[static_cast<std::size_t>(a.col())];
      if (column >= 0) result.matrix.insertBack(i, column) = a.value();
    }
  }
  result.matrix.finalize();
  return result;
}

Eigen::VectorXd reduced_load(const RowMatrix& matrix, const Eigen::VectorXd& load, std::span<const char> fixed,
                             std::span<const double> given) {
  Eigen::VectorXd result(std::ranges::count(fixed, 0));
  Eigen::Index i = 0;
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v]) continue;
    const auto row = static_cast<Eigen::Index>(v);
    double sum = load[row];
    for (RowMatrix::InnerIterator a(matrix, row); a; ++a) {
      const auto w = static_cast<std::size_t>(a.col());
      if (fixed[w]) sum -= a.value() * given[w];
    }
    result[i++] = sum;
  }
  return result;
}

}  // namespace parmesan
