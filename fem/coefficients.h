#pragma once

#include "fem/p1.h"
#include "fem/problem.h"

namespace parmesan {

/// The value itself. Errors: ProblemError with the name and the place unless it is finite.
double require_finite(double value, const char* name, const Point& point);

/// K at a point of a region, the identity where the problem gives none.
/// Errors: ProblemError with the place unless it is finite and positive definite.
Diffusion diffusion_at(const Problem& problem, const Point& point, int region);

/// b, c and f at a point of a region, zero where the problem gives none.
/// Errors: ProblemError with the place unless they are finite.
Vector velocity_at(const Problem& problem, const Point& point, int region);
double reaction_at(const Problem& problem, const Point& point, int region);
double source_at(const Problem& problem, const Point& point, int region);

/// Means of K and b over an element, by the degree 4 rule.
struct MeanCoefficients {
  Diffusion diffusion;
  Vector velocity;
};
MeanCoefficients mean_coefficients(const Problem& problem, const P1Element& element, int region);

/// What the load is integrated from: int r phi + q.grad phi - the boundary integral of n.q phi, with q the flux and r
/// the remainder of the divergence form if the problem has one and no velocity; else q = 0 and r is the source. Errors:
/// ProblemError with the place unless they are finite.
bool uses_divergence_form(const Problem& problem);
double remainder_at(const Problem& problem, const Point& point, int region);
Vector source_flux_at(const Problem& problem, const Point& point, int region);

}  // namespace parmesan
