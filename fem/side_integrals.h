#pragma once

#include "fem/problem.h"
#include "fem/sides.h"

namespace parmesan {

/// g at a point of a side, zero where the problem gives none; name: what g is, for the message.
/// Errors: ProblemError with the place unless it is finite.
double data_at(const BoundaryData& g, const Side& side, const Point& x, const char* name = "boundary data");

/// Integrals of g phi_from and g phi_to over a side, and of |g|.
struct SideMoments {
  double from = 0.0;
  double to = 0.0;
  double magnitude = 0.0;
};

/// The moments of g, by 4 Gauss points on halves of the side until they confirm each other.
/// Errors: ProblemError where g is not finite.
SideMoments side_moments(const Mesh& mesh, const Side& side, const BoundaryData& g);

/// The moments of n.q, q the flux of a source in divergence form; zero where it has none. For an interior constraint,
/// across which q may jump, those of n.(q_left - q_right), each a little inside of its triangle.
/// Errors: ProblemError where q is not finite.
SideMoments source_flux_moments(const Mesh& mesh, const Problem& problem, const Side& side);

/// Integrals of a phi_i phi_j over a side, and the range of a.
struct RobinMoments {
  double from_from = 0.0;
  double from_to = 0.0;
  double to_to = 0.0;
  double min = 0.0;
  double max = 0.0;
};

/// The moments of a Robin coefficient, by 4 Gauss points. Errors: ProblemError where a is not finite.
RobinMoments robin_moments(const Mesh& mesh, const Side& side, const BoundaryData& a);

/// The moments of a q, by the same points: q the quadratic on the side with this surplus in the middle and 0 at the
/// ends.
SideMoments quadratic_robin_moments(const Mesh& mesh, const Side& side, const BoundaryData& a, double surplus);

}  // namespace parmesan
