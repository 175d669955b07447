#pragma once

#include <span>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// How much a metric may have coarsened at the displacement d from where it is m:
/// eta^2 = (1 + l ln beta)^-2, l = sqrt(d^T M d); sizes grow by 1 + l ln beta, near beta per unit of
/// metric length (Alauzet, Finite Elem. Anal. Des. 46 (2010), metric-space gradation).
double growth_factor(const Metric& m, const Vector& d, double beta);

/// The coarsest metrics below the given ones with M_q >= eta^2(pq) M_p, in both directions, on every
/// edge pq of the mesh, up to one part in 10^6.
///
/// Each vertex is intersected with what its neighbours allow until nothing changes, in sweeps over the vertices that
/// the one before has changed, by their numbers. After 200 visits to each vertex the bound may still fail on some
/// edges.
///
/// beta: growth of size per unit of metric length, > 1.
/// Errors: InputError for beta <= 1 or a wrong number of metrics. Cost: O(n), each vertex visited a few times.
std::vector<Metric> limit_gradation(const Mesh& mesh, std::span<const Metric> metrics, double beta);

}  // namespace parmesan
