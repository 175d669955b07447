#include "fem/reduction.h"

namespace parmesan {

ReducedSystem reduce(const AssembledSystem& system, const FixedVertices& fixed) {
  ReducedSystem result;
  std::vector<int> unknown(fixed.fixed.size(), -1);
  for (std::size_t v = 0; v < fixed.fixed.size(); ++v) {
    if (fixed.fixed[v]) continue;
    unknown[v] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(static_cast<int>(v));
  }
  const auto n = static_cast<Eigen::Index>(result.vertices.size());
  result.matrix.resize(n, n);
  result.matrix.reserve(system.matrix.nonZeros());
  result.load.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const int v = result.vertices[static_cast<std::size_t>(i)];
    result.load[i] = system.load[v];
    result.matrix.startVec(i);
    for (RowMatrix::InnerIterator a(system.matrix, v); a; ++a) {
      const auto w = static_cast<std::size_t>(a.col());
      if (unknown[w] >= 0) {
        result.matrix.insertBack(i, unknown[w]) = a.value();
      } else {
        result.load[i] -= a.value() * fixed.values[w];
      }
    }
  }
  result.matrix.finalize();
  return result;
}

}  // namespace parmesan
