#include "fem/multigrid.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace parmesan {

namespace {

constexpr int coarsest_size = 1000;
constexpr double finest_strength = 0.08;  // of a coupling on the finest level, halved on each coarser one

/// The entries of one row.
struct Row {
  std::span<const int> columns;
  std::span<const double> values;
};

Row row_of(const RowMatrix& matrix, int row) {
  const auto begin = static_cast<std::size_t>(matrix.outerIndexPtr()[row]);
  const auto size = static_cast<std::size_t>(matrix.outerIndexPtr()[row + 1]) - begin;
  return {{matrix.innerIndexPtr() + begin, size}, {matrix.valuePtr() + begin, size}};
}

/// The matrix without its weak couplings, |a_ij| <= strength sqrt(a_ii a_jj), which are added to
/// the diagonal so that the rows keep their sums. Where nothing but round-off would be left of it, as where all
/// couplings are weak, the diagonal stays.
RowMatrix filter(const RowMatrix& matrix, double strength) {
  constexpr double least_share = 1e-3;  // of the diagonal
  const Eigen::VectorXd diagonal = matrix.diagonal();
  RowMatrix filtered = matrix;
  for (int i = 0; i < matrix.rows(); ++i) {
    double weak = 0.0;
    for (RowMatrix::InnerIterator a(filtered, i); a; ++a) {
      const bool keep = a.col() == i || a.value() * a.value() > strength * strength * diagonal[i] * diagonal[a.col()];
      if (keep) continue;
      weak += a.value();
      a.valueRef() = 0.0;
    }
    if (diagonal[i] + weak > least_share * diagonal[i]) filtered.coeffRef(i, i) += weak;
  }
  filtered.prune([](Eigen::Index row, Eigen::Index col, double value) { return row == col || value != 0.0; });
  return filtered;
}

/// Aggregates of strongly coupled unknowns.
struct Aggregates {
  std::vector<int> of;  // aggregate of each unknown, -1 for one without strong couplings
  int count = 0;
};

/// First whole neighbourhoods, then what is left joins a neighbour (Vanek et al. 1996, algorithm 2).
Aggregates aggregate(const RowMatrix& filtered) {
  const int n = static_cast<int>(filtered.rows());
  Aggregates result{std::vector<int>(static_cast<std::size_t>(n), -1), 0};
  const auto of = [&result](int i) -> int& { return result.of[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < n; ++i) {
    const std::span<const int> ring = row_of(filtered, i).columns;
    if (ring.size() < 2 || std::ranges::any_of(ring, [&of](int j) { return of(j) >= 0; })) continue;
    for (const int j : ring) of(j) = result.count;
    ++result.count;
  }
  const std::vector<int> roots = result.of;
  for (int i = 0; i < n; ++i) {
    if (of(i) >= 0) continue;
    const Row row = row_of(filtered, i);
    double strongest = 0.0;
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
      const int root = roots[static_cast<std::size_t>(row.columns[k])];
      if (root < 0 || std::abs(row.values[k]) <= strongest) continue;
      strongest = std::abs(row.values[k]);
      of(i) = root;
    }
  }
  return result;
}

/// Largest eigenvalue of D^-1 A by a few power iterations, from below.
double spectral_radius(const RowMatrix& matrix, const Eigen::VectorXd& diagonal) {
  Eigen::VectorXd x(matrix.rows());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = std::sin(1.0 + 12.9898 * static_cast<double>(i));
  double radius = 1.0;
  for (int step = 0; step < 12; ++step) {
    const Eigen::VectorXd y = (matrix * x).cwiseQuotient(diagonal);
    radius = y.norm() / x.norm();
    x = y / y.norm();
  }
  return radius;
}

/// Piecewise constant prolongation smoothed once, P = (I - w D^-1 A) P0, w = 4 / (3 radius).
RowMatrix smoothed_prolongation(const RowMatrix& filtered, const Aggregates& aggregates) {
  const Eigen::VectorXd diagonal = filtered.diagonal();
  const double damping = 4.0 / (3.0 * 1.1 * spectral_radius(filtered, diagonal));
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(filtered.nonZeros()));
  for (int i = 0; i < filtered.rows(); ++i) {
    for (RowMatrix::InnerIterator a(filtered, i); a; ++a) {
      const int coarse = aggregates.of[static_cast<std::size_t>(a.col())];
      const double value = (a.col() == i ? 1.0 : 0.0) - damping * a.value() / diagonal[i];
      if (coarse >= 0) entries.emplace_back(i, coarse, value);
    }
  }
  RowMatrix prolongation(filtered.rows(), aggregates.count);
  prolongation.setFromTriplets(entries.begin(), entries.end());
  return prolongation;
}

/// x_i = (b_i - sum_{j != i} a_ij x_j) / a_ii for one row.
void relax_row(const RowMatrix& matrix, const Eigen::VectorXd& b, int i, Eigen::VectorXd& x) {
  const Row row = row_of(matrix, i);
  double residual = b[i];
  double diagonal = 1.0;
  for (std::size_t k = 0; k < row.columns.size(); ++k) {
    if (row.columns[k] == i) {
      diagonal = row.values[k];
    } else {
      residual -= row.values[k] * x[row.columns[k]];
    }
  }
  x[i] = residual / diagonal;
}

}  // namespace

AggregationMultigrid& AggregationMultigrid::compute(const RowMatrix& matrix) {
  levels_.clear();
  RowMatrix current = matrix;
  double strength = finest_strength;
  while (current.rows() > coarsest_size) {
    const RowMatrix filtered = filter(current, strength);
    const Aggregates aggregates = aggregate(filtered);
    if (aggregates.count == 0 || 10L * aggregates.count > 9 * current.rows()) break;
    Level level;
    level.prolongation = smoothed_prolongation(filtered, aggregates);
    level.restriction = level.prolongation.transpose();
    const RowMatrix product = current * level.prolongation;
    level.matrix.swap(current);
    current = level.restriction * product;
    levels_.push_back(std::move(level));
    strength *= 0.5;
  }
  coarsest_.compute(current);
  return *this;
}

Eigen::VectorXd AggregationMultigrid::cycle(std::size_t level, const Eigen::VectorXd& b) const {
  if (level == levels_.size()) return coarsest_.solve(b);
  const RowMatrix& matrix = levels_[level].matrix;
  const int n = static_cast<int>(matrix.rows());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  for (int i = 0; i < n; ++i) relax_row(matrix, b, i, x);
  const Eigen::VectorXd residual = b - matrix * x;
  x += levels_[level].prolongation * cycle(level + 1, levels_[level].restriction * residual);
  for (int i = n - 1; i >= 0; --i) relax_row(matrix, b, i, x);
  return x;
}

}  // namespace parmesan
