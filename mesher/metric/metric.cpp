#include "mesher/metric/metric.h"

#include <algorithm>
#include <string>

#include "mesher/errors.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

void require_size(double h) {
  if (!(std::isfinite(h) && h > 0.0)) throw InputError("a mesh size must be finite and positive, not " + text(h));
  const double inverse_square = 1.0 / (h * h);
  if (!(std::isfinite(inverse_square) && inverse_square > 0.0))
    throw InputError("a mesh size must have a square that is a number, not " + text(h));
}

}  // namespace

Metric Metric::isotropic(double h) { return from_sizes(h, h, 0.0); }

Metric Metric::from_sizes(double h1, double h2, double angle) {
  require_size(h1);
  require_size(h2);
  return from_tensor(compose({1.0 / (h1 * h1), 1.0 / (h2 * h2), {std::cos(angle), std::sin(angle)}}));
}

Metric Metric::from_tensor(const SymmetricTensor& t) {
  const bool finite = std::isfinite(t.xx) && std::isfinite(t.xy) && std::isfinite(t.yy);
  if (!finite || t.xx <= 0.0 || t.yy <= 0.0 || eigenvalues(t).second <= 0.0) {
    throw InputError("a metric must be finite and positive definite, not [" + text(t.xx) + " " + text(t.xy) + "; " +
                     text(t.xy) + " " + text(t.yy) + "]");
  }
  return Metric(t);
}

Metric Metric::isotropised() const {
  const double d = density();
  return Metric(SymmetricTensor{d, 0.0, d});
}

// In the eigenbasis of A^-1/2 B A^-1/2 both metrics are diagonal: A is I, B has its eigenvalues.
Metric intersect(const Metric& a, const Metric& b) {
  Eigen2 root = eigen_decomposition(a.tensor());
  root.l1 = std::sqrt(root.l1);
  root.l2 = std::sqrt(root.l2);
  const SymmetricTensor sqrt_a = compose(root);
  const SymmetricTensor inv_sqrt_a = compose({1.0 / root.l1, 1.0 / root.l2, root.axis});
  const auto congruent = [](const SymmetricTensor& s, const SymmetricTensor& t) {
    const Vector column_x = t * Vector{s.xx, s.xy};
    const Vector column_y = t * Vector{s.xy, s.yy};
    return SymmetricTensor{dot({s.xx, s.xy}, column_x), dot({s.xx, s.xy}, column_y), dot({s.xy, s.yy}, column_y)};
  };
  Eigen2 reduced = eigen_decomposition(congruent(inv_sqrt_a, b.tensor()));
  reduced.l1 = std::max(reduced.l1, 1.0);
  reduced.l2 = std::max(reduced.l2, 1.0);
  return Metric(congruent(sqrt_a, compose(reduced)));
}

}  // namespace parmesan
