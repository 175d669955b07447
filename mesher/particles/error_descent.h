#pragma once

#include <numbers>
#include <vector>

#include "mesher/index.h"
#include "mesher/metric/tensor_field.h"
#include "mesher/particles/error_star.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// Effort of a descent, and what it must not spoil: a change that breaks a limit is taken only if it makes what
/// breaks it no worse than it was.
struct ErrorDescentOptions {
  int sweeps = 10;           // of flips and moves
  double min_quality = 0.5;  // mean ratio of a triangle in the mean of its vertex metrics
  double max_length =
      std::numbers::sqrt2;  // of an edge in the mean of its end metrics; its inverse is the least length
};

/// Lowers the L2 error of linear interpolation itself: moves particles and flips edges wherever that makes the
/// sum of squared_error over the triangles smaller, each in the mean Hessian of its vertices.
///
/// The Hessian keeps its sign: where det H < 0 the error is four times as sensitive to shape as |H| says, and
/// moves that lower an energy of |H| do not lower the error. Only the L2 norm is meant: in other
/// norms other triangles are best. The limit on lengths costs 0.2 % of error; it keeps the mesh what the metric
/// asked for, and particles from being misled where the mesh does not resolve the function.
///
/// Where the Hessian is not finite nothing changes. Same input, same bits.
class ErrorDescent {
 public:
  /// Refers to the particles and the field of signed Hessians, which must outlive the descent. No particle
  /// may be created, annihilated or moved by others meanwhile.
  ErrorDescent(ParticleSystem& particles, const TensorField& hessian, const ErrorDescentOptions& options = {});

  /// The sum over all triangles. Units: U^2 L^2. Cost: O(n).
  double squared_error() const;

  /// Visits every particle once, in the order of its number: free ones and those on a segment, along it, go a
  /// Newton step, halved up to three times until the error of the star falls. Returns how many moved.
  int move_particles();

  /// Flips each free edge, visited once, whose other diagonal has the smaller error. Returns the number of flips.
  int flip_edges();

 private:
  const SymmetricTensor& hessian(VertexId v) const { return hessians_[at(v)]; }
  double triangle_error(VertexId a, VertexId b, VertexId c) const;
  bool descend(VertexId v);
  bool try_place(VertexId v, const Point& to, double error_before);
  bool wants_flip(EdgeId e) const;

  ParticleSystem& particles_;
  const TensorField& field_;
  ErrorDescentOptions options_;
  std::vector<SymmetricTensor> hessians_;  // one per vertex slot
  std::vector<MetricHint> hints_;          // for look-ups in the field
  ErrorStar around_;                       // of the particle being moved
};

/// The whole stage: sweeps of flips and moves, and a last pass of flips. Cost: O(n) per sweep.
void lower_error(ParticleSystem& particles, const TensorField& hessian, const ErrorDescentOptions& options = {});

}  // namespace parmesan
