#pragma once

#include "mesher/particles/potentials.h"
#include "mesher/particles/star.h"

namespace parmesan {

/// The step, cut to metric length 1/2 where it is longer.
Vector shortened(const Vector& step, const Metric& m);

/// Displacement of a particle at p that feels m, first order (thesis 3.12 with 5.16 and 5.8):
///
///     dx = -2 delta sum_j phi'(l_j) / l_j r_j,   r_j = x_j - p,   l_j^2 = r_j^T (M + M_j)/2 r_j
///
/// over its neighbours N1, shortened to metric length 1/2. Units: L.
Vector force_step(const Star& star, const Point& p, const Metric& m);

/// Displacement to the mean of the apexes that the triangles of the star would like: equilateral,
/// in the mean of their vertex metrics, on the side that the particle does not belong to. Units: L.
Vector ideal_apex_step(const Star& star, const Point& p, const Metric& m);

}  // namespace parmesan
