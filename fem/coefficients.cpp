#include "fem/coefficients.h"

#include <cmath>
#include <string>

#include "mesher/number_text.h"

namespace parmesan {

namespace {

double scalar_at(const ScalarCoefficient& coefficient, const char* name, const Point& point, int region) {
  return coefficient ? require_finite(coefficient(point, region), name, point) : 0.0;
}

}  // namespace

double require_finite(double value, const char* name, const Point& point) {
  if (std::isfinite(value)) return value;
  throw ProblemError(std::string(name) + " is " + text(value) + " at " + text(point) + "; it must be finite");
}

Diffusion diffusion_at(const Problem& problem, const Point& point, int region) {
  if (!problem.diffusion) return identity_tensor;
  const Diffusion k = problem.diffusion(point, region);
  for (const double entry : {k.xx, k.xy, k.yy}) require_finite(entry, "diffusion", point);
  if (k.xx > 0.0 && k.yy > 0.0 && k.yy > k.xy / k.xx * k.xy) return k;
  throw ProblemError("diffusion is [[" + text(k.xx) + ", " + text(k.xy) + "], [" + text(k.xy) + ", " + text(k.yy) +
                     "]] at " + text(point) + "; it must be positive definite");
}

Vector velocity_at(const Problem& problem, const Point& point, int region) {
  if (!problem.velocity) return {};
  const Vector b = problem.velocity(point, region);
  return {require_finite(b.x, "velocity", point), require_finite(b.y, "velocity", point)};
}

double reaction_at(const Problem& problem, const Point& point, int region) {
  return scalar_at(problem.reaction, "reaction", point, region);
}

double source_at(const Problem& problem, const Point& point, int region) {
  return scalar_at(problem.source, "source", point, region);
}

MeanCoefficients mean_coefficients(const Problem& problem, const P1Element& element, int region) {
  MeanCoefficients mean;
  for (const auto& [lambda, weight] : degree4_rule()) {
    const Point x = element.at(lambda);
    const Diffusion k = diffusion_at(problem, x, region);
    mean.diffusion = mean.diffusion + weight * k;
    mean.velocity = mean.velocity + weight * velocity_at(problem, x, region);
  }
  return mean;
}

bool uses_divergence_form(const Problem& problem) { return problem.divergence_form && !problem.velocity; }

double remainder_at(const Problem& problem, const Point& point, int region) {
  const bool weak = uses_divergence_form(problem);
  return scalar_at(weak ? problem.divergence_form->remainder : problem.source, "source", point, region);
}

Vector source_flux_at(const Problem& problem, const Point& point, int region) {
  if (!uses_divergence_form(problem)) return {};
  const Vector q = problem.divergence_form->flux(point, region);
  return {require_finite(q.x, "the flux of the source", point), require_finite(q.y, "the flux of the source", point)};
}

}  // namespace parmesan
