#pragma once

#include <span>
#include <vector>

#include "adapt/absolute_hessian.h"
#include "adapt/clipped_sizes.h"
#include "adapt/metric_options.h"
#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// What is asked of a metric beyond the case's options.
struct MetricRequest {
  MetricOptions options;
  ErrorMeasure measure = ErrorMeasure::Lp;
  bool norms = false;                      // are aimed at beside a goal functional, where there is one
  bool isotropic = false;                  // the best metric of the form s I, from the largest |eigenvalue|
  double complexity = 1000.0;              // integral of sqrt(det M) asked for
  std::vector<SymmetricTensor> influence;  // per vertex, of `influence`: bounds aspects where there is one
};

/// A metric per vertex and what the limits did to it.
struct HessianMetric {
  std::vector<Metric> metrics;
  double complexity = 0.0;  // reached; differs from the one asked for where the limits forbid it
  double floor = 0.0;       // smallest eigenvalue that |H| was given, in units of H
  ClippedSizes clipped;     // vertices
};

/// Integral of sqrt(det M) over the mesh, log-Euclidean in between, by the 7-point rule of vertices,
/// edge midpoints and centroid (degree 3).
double complexity(const Mesh& mesh, std::span<const Metric> metrics);

/// The density relative to det H > 0 that is best where det H < 0, for triangles equilateral in |H|
/// (0.547, 1/2, 0.509, 0.75 for p = 1, 2, 4, infinity; in between linear in 1/p).
double sign_factor(double norm);

/// The smallest eigenvalue |H| is given: where det H vanishes, det^(-1/(2p+2)) would be infinite and
/// a mesh blind. Chosen so that the whole domain at the floor would take 2 % of the complexity, or 100 vertices if
/// that is less, but at least 1e-12 of the largest eigenvalue, and 1 where H vanishes identically.
double eigenvalue_floor(const Mesh& mesh, std::span<const AbsoluteHessian> hessians, const MetricRequest& request);

/// |H| with the floor, scaled for the norm and the sign, before the factor D that sets the complexity.
/// Lp: det^(-1/(2p+2)) |H| (Loseille & Alauzet 2011), times sign_factor where det H < 0.
/// H1: tr^(1/2) det^(-1/4) |H|, times sqrt2 where det H < 0.
/// Where max_aspect binds, det and tr are those of the eigenvalues it leaves, and the factor for the sign lies between
/// those of the signs: triangles shorter than |H| asks for hardly see the smaller second derivative.
SymmetricTensor scale_for_error(const AbsoluteHessian& hessian, double floor, const MetricRequest& request);

/// The stages in order: floors, norm and sign, sizes and aspect, gradation; then the factor D is
/// iterated until the complexity after all of them is the one asked for. Limits win.
///
/// Errors: InputError when the counts differ or a limit is not usable (size_limits).
HessianMetric metric_from_hessians(const Mesh& mesh, std::span<const AbsoluteHessian> hessians,
                                   const MetricRequest& request);

/// The metric that satisfies two, each of the request's complexity, with the limits and the complexity of the request
/// once more. Errors: as metric_from_hessians.
HessianMetric intersected(const Mesh& mesh, const HessianMetric& a, const HessianMetric& b,
                          const MetricRequest& request);

}  // namespace parmesan
