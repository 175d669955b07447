#include "fem/patch_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "fem/adjacency.h"

namespace parmesan {

namespace {

constexpr std::size_t MinPoints = 9;
constexpr int MaxRings = 4;
constexpr double MinReciprocalCondition = 1e-10;  // of the normal equations in scaled coordinates
constexpr double WeightDecay = 0.5;               // of exp(-decay rho^2), rho in standard deviations

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Lower triangular G with G G^T the covariance of a patch; scaled coordinates are s = G^-1 d.
struct Scaling {
  double g11 = 1.0;
  double g21 = 0.0;
  double g22 = 1.0;

  Vector scaled(const Vector& d) const {
    const double s = d.x / g11;
    return {s, (d.y - g21 * s) / g22};
  }
};

Scaling scaling_of(std::span<const Vector> offsets) {
  double xx = 0.0;
  double xy = 0.0;
  for (const Vector& d : offsets) {
    xx += d.x * d.x;
    xy += d.x * d.y;
  }
  const auto n = static_cast<double>(offsets.size());
  Scaling g;
  g.g11 = std::sqrt(xx / n);
  if (!(g.g11 > 0.0)) g.g11 = 1.0;
  g.g21 = xy / n / g.g11;
  double rest = 0.0;  // summed after the projection: no digits lost on stretched patches
  for (const Vector& d : offsets) {
    const double y = d.y - g.g21 / g.g11 * d.x;
    rest += y * y;
  }
  g.g22 = std::sqrt(rest / n);
  if (!(g.g22 > 0.0)) g.g22 = 1.0;
  return g;
}

/// Values 1, s, t, s^2/2, s t, t^2/2 of the monomials.
Vector6 monomials(const Vector& s) {
  return (Vector6() << 1.0, s.x, s.y, 0.5 * s.x * s.x, s.x * s.y, 0.5 * s.y * s.y).finished();
}

/// Derivatives from those in scaled coordinates, grad = G^-T grad_s, H = G^-T H_s G^-1.
PatchFit unscaled(const Vector6& p, const Scaling& g) {
  const double a = 1.0 / g.g11;
  const double c = 1.0 / g.g22;
  const double b = -g.g21 * a * c;  // G^-1 = [a 0; b c]
  PatchFit fit;
  fit.gradient = {a * p[1] + b * p[2], c * p[2]};
  fit.hessian = {a * a * p[3] + 2.0 * a * b * p[4] + b * b * p[5], c * (a * p[4] + b * p[5]), c * c * p[5]};
  return fit;
}

/// The vertices near one vertex, itself first, and the polynomial fitted to their values.
class Patch {
 public:
  Patch(const Mesh& mesh, const Adjacency& neighbours, std::span<const double> values)
      : mesh_(mesh), neighbours_(neighbours), values_(values), mark_(mesh.points.size(), -1) {}

  PatchFit fit(int vertex) {
    vertices_.assign(1, vertex);
    mark_[static_cast<std::size_t>(vertex)] = vertex;
    ring_begin_ = 0;
    for (int ring = 1; ring <= MaxRings && grow(vertex); ++ring) {
      if (vertices_.size() < MinPoints) continue;
      assemble(vertex);
      const Eigen::LDLT<Matrix6> factors(matrix_);
      if (factors.rcond() > MinReciprocalCondition) return unscaled(factors.solve(load_), scaling_);
    }
    assemble(vertex);
    return unscaled(Eigen::CompleteOrthogonalDecomposition<Matrix6>(matrix_).solve(load_), scaling_);
  }

 private:
  /// Adds the next ring; false when there is none.
  bool grow(int centre) {
    const std::size_t end = vertices_.size();
    for (std::size_t i = ring_begin_; i < end; ++i) {
      for (const int w : neighbours_.of(vertices_[i])) {
        int& mark = mark_[static_cast<std::size_t>(w)];
        if (mark == centre) continue;
        mark = centre;
        vertices_.push_back(w);
      }
    }
    ring_begin_ = end;
    return vertices_.size() > end;
  }

  /// The normal equations of the fit.
  void assemble(int centre) {
    const auto c = static_cast<std::size_t>(centre);
    offsets_.clear();
    for (const int v : vertices_) offsets_.push_back(mesh_.points[static_cast<std::size_t>(v)] - mesh_.points[c]);
    scaling_ = scaling_of(offsets_);
    matrix_.setZero();
    load_.setZero();
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Vector s = scaling_.scaled(offsets_[i]);
      const double weight = std::exp(-WeightDecay * squared_norm(s));
      const Vector6 m = monomials(s);
      matrix_.noalias() += (weight * m) * m.transpose();
      load_ += weight * (values_[static_cast<std::size_t>(vertices_[i])] - values_[c]) * m;
    }
  }

  const Mesh& mesh_;
  const Adjacency& neighbours_;
  std::span<const double> values_;
  std::vector<int> mark_;  // the last centre that had the vertex in its patch
  std::vector<int> vertices_;
  std::vector<Vector> offsets_;
  std::size_t ring_begin_ = 0;
  Scaling scaling_;
  Matrix6 matrix_ = Matrix6::Zero();
  Vector6 load_ = Vector6::Zero();
};

}  // namespace

std::vector<PatchFit> fit_patches(const Mesh& mesh, std::span<const double> values) {
  const Adjacency neighbours = vertex_neighbours(mesh);
  Patch patch(mesh, neighbours, values);
  std::vector<PatchFit> fits;
  fits.reserve(mesh.points.size());
  for (int v = 0; v < mesh.num_vertices(); ++v) fits.push_back(patch.fit(v));
  return fits;
}

}  // namespace parmesan
