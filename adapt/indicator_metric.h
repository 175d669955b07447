#pragma once

#include <span>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// What indicators belong to.
enum class IndicatorPlace { Triangles, Vertices };

/// How a user's own error indicators are turned into sizes.
struct IndicatorRequest {
  double order = 2.0;        // q: the error falls as h^q; 2 for the L2 norm of P1, 1 for its H1 norm
  double complexity = 0.0;   // integral of sqrt(det M) asked for
  double max_change = 16.0;  // sizes change by this factor at most
  IndicatorPlace place = IndicatorPlace::Triangles;
};

/// Isotropic metrics, one per vertex, that make the error smallest that indicators tell of.
///
/// indicators: eta >= 0 per triangle or per vertex (request.place), its share of the norm of the error: |e|^2 = sum
/// eta^2. A vertex stands for a third of the triangles around it. With the present sizes h, h^2 = 4 |K| / sqrt3 on a
/// triangle K, the error's density eta^2 / |K| is c^2 h^2q; the integral of c^2 h^2q at a given integral of h^-2 is
/// smallest for
///
///     h_new^-2 = D c^(2 / (q + 1)),    c = eta / (sqrt|K| h^q),
///
/// with D such that the complexity is the one asked for.
/// Units: L^-2. Errors: InputError for a count that is not theirs, for values that are negative or not finite, and
/// where all are 0.
std::vector<Metric> metric_from_indicators(const Mesh& mesh, std::span<const double> indicators,
                                           const IndicatorRequest& request);

}  // namespace parmesan
