#pragma once

#include <Eigen/Dense>
#include <optional>
#include <span>
#include <vector>

#include "fem/adjacency.h"
#include "fem/hessian.h"
#include "mesher/index.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Lower triangular G with G G^T the covariance of a patch; scaled coordinates are s = G^-1 d, so that
/// stretched patches are as well conditioned as round ones.
struct PatchScaling {
  double g11 = 1.0;
  double g21 = 0.0;
  double g22 = 1.0;

  Vector scaled(const Vector& d) const {
    const double s = d.x / g11;
    return {s, (d.y - g21 * s) / g22};
  }
};

/// Derivatives at a vertex of a quadratic polynomial.
struct PatchFit {
  Vector gradient;
  Hessian hessian;
};

/// Derivatives from those in scaled coordinates, grad = G^-T grad_s, H = G^-T H_s G^-1.
PatchFit unscaled(const Vector& gradient, const Hessian& hessian, const PatchScaling& scaling);

/// The vertices near one vertex, that one first, ring by ring.
class VertexPatch {
 public:
  static constexpr int max_rings = 4;

  explicit VertexPatch(const Mesh& mesh);

  /// The patch of the vertex alone. Cost: O(1).
  void start(int vertex);

  /// Adds the next ring; false when there is none.
  bool grow();

  int centre() const { return vertices_.front(); }
  std::span<const int> vertices() const { return vertices_; }
  std::span<const int> neighbours(int vertex) const { return neighbours_.of(vertex); }
  bool holds(int vertex) const { return mark_[at(vertex)] == stamp_; }
  bool is_inner(int vertex) const { return inner_[at(vertex)]; }

  /// From the centre to each vertex of the patch. Units: L.
  std::span<const Vector> offsets() const { return offsets_; }

 private:
  const Mesh& mesh_;
  Adjacency neighbours_;
  std::vector<bool> inner_;  // triangles all around
  std::vector<int> mark_;    // the last patch that the vertex was in
  int stamp_ = 0;            // of the present patch
  std::vector<int> vertices_;
  std::vector<Vector> offsets_;
  std::size_t ring_begin_ = 0;
};

PatchScaling covariance_scaling(std::span<const Vector> offsets);

/// Weight of a point of a patch in a fit, exp(-rho^2 / 2), rho in standard deviations.
double patch_weight(const Vector& scaled);

/// Normal equations of a least-squares fit with N unknowns.
template <int N>
struct NormalEquations {
  Eigen::Matrix<double, N, N> matrix = Eigen::Matrix<double, N, N>::Zero();
  Eigen::Matrix<double, N, 1> load = Eigen::Matrix<double, N, 1>::Zero();
  std::size_t rows = 0;

  void add(double weight, const Eigen::Matrix<double, N, 1>& row, double value) {
    matrix.noalias() += (weight * row) * row.transpose();
    load += weight * value * row;
    ++rows;
  }
};

/// The unknowns; nothing unless the equations determine them well. Points near a conic do not: the gradients of
/// boundary vertices fitted to two rows of vertices were off by 0.5 where a reciprocal condition of 1e-4 was taken, by
/// 0.013 with 1e-2.
template <int N>
std::optional<Eigen::Matrix<double, N, 1>> solution(const NormalEquations<N>& equations,
                                                    double min_reciprocal_condition = 1e-2) {
  constexpr double min_pivot = 1e-12;  // over the largest: of exactly singular equations rcond knows nothing
  const Eigen::LDLT<Eigen::Matrix<double, N, N>> factors(equations.matrix);
  const bool definite = factors.vectorD().minCoeff() > min_pivot * factors.vectorD().maxCoeff();
  if (!definite || !(factors.rcond() > min_reciprocal_condition)) return std::nullopt;
  return factors.solve(equations.load);
}

/// Solves the fit on the smallest patch around the vertex that has this many rows and determines the
/// unknowns well; where four rings do not, that of the largest patch, the smallest one where there are many.
/// assemble: (const VertexPatch&) -> NormalEquations<N>, in scaled coordinates.
template <int N, class Assemble>
Eigen::Matrix<double, N, 1> fit_on_patch(VertexPatch& patch, int vertex, std::size_t min_rows, Assemble assemble) {
  patch.start(vertex);
  for (int ring = 1; ring <= VertexPatch::max_rings && patch.grow(); ++ring) {
    const NormalEquations<N> equations = assemble(patch);
    if (equations.rows < min_rows) continue;
    if (const auto fit = solution(equations)) return *fit;
  }
  constexpr double barely_determined = 1e-10;
  const NormalEquations<N> equations = assemble(patch);
  if (const auto fit = solution(equations, barely_determined)) return *fit;
  return Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, N, N>>(equations.matrix).solve(equations.load);
}

}  // namespace parmesan
