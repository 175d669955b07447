#include "fem/quadrature.h"

#include <cmath>
#include <numbers>

namespace parmesan {

namespace {

/// The Legendre polynomial of degree n at z and its derivative.
struct Legendre {
  double value = 1.0;
  double slope = 0.0;
};

Legendre legendre(int n, double z) {
  double before = 1.0;
  double last = z;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * z * last - (k - 1) * before) / k;
    before = last;
    last = next;
  }
  return {last, n * (z * last - before) / (z * z - 1.0)};
}

/// The i-th largest root of the Legendre polynomial of degree n, by Newton's method.
double legendre_root(int n, int i) {
  double z = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
  for (int step = 0; step < 100; ++step) {
    const Legendre p = legendre(n, z);
    z -= p.value / p.slope;
    if (std::abs(p.value / p.slope) < 1e-15) break;
  }
  return z;
}

constexpr double A1 = 0.108103018168070227;
constexpr double A2 = 0.445948490915964886;
constexpr double WA = 0.223381589678011466;
constexpr double B1 = 0.816847572980458514;
constexpr double B2 = 0.091576213509770743;
constexpr double WB = 0.109951743655321868;

constexpr std::array<TrianglePoint, 6> Degree4{{{{A1, A2, A2}, WA},
                                                {{A2, A1, A2}, WA},
                                                {{A2, A2, A1}, WA},
                                                {{B1, B2, B2}, WB},
                                                {{B2, B1, B2}, WB},
                                                {{B2, B2, B1}, WB}}};

constexpr double C1 = 0.501426509658179;
constexpr double C2 = 0.249286745170910;
constexpr double WC = 0.116786275726379;
constexpr double D1 = 0.873821971016996;
constexpr double D2 = 0.063089014491502;
constexpr double WD = 0.050844906370207;
constexpr double E1 = 0.053145049844817;
constexpr double E2 = 0.310352451033784;
constexpr double E3 = 0.636502499121399;
constexpr double WE = 0.082851075618374;

constexpr std::array<TrianglePoint, 12> Degree6{{{{C1, C2, C2}, WC},
                                                 {{C2, C1, C2}, WC},
                                                 {{C2, C2, C1}, WC},
                                                 {{D1, D2, D2}, WD},
                                                 {{D2, D1, D2}, WD},
                                                 {{D2, D2, D1}, WD},
                                                 {{E1, E2, E3}, WE},
                                                 {{E1, E3, E2}, WE},
                                                 {{E2, E1, E3}, WE},
                                                 {{E2, E3, E1}, WE},
                                                 {{E3, E1, E2}, WE},
                                                 {{E3, E2, E1}, WE}}};

}  // namespace

std::vector<SegmentPoint> gauss_rule(int n) {
  std::vector<SegmentPoint> rule;
  for (int i = 0; i < n; ++i) {
    const double z = legendre_root(n, i);
    const double slope = legendre(n, z).slope;
    rule.push_back({0.5 * (1.0 - z), 1.0 / ((1.0 - z * z) * slope * slope)});
  }
  return rule;
}

std::vector<TrianglePoint> conical_rule(int n) {
  const std::vector<SegmentPoint> gauss = gauss_rule(n);
  std::vector<TrianglePoint> rule;
  for (const SegmentPoint& p : gauss) {
    for (const SegmentPoint& q : gauss) {
      const double s = p.t;
      const double t = q.t * (1.0 - s);
      rule.push_back({{1.0 - s - t, s, t}, 2.0 * p.weight * q.weight * (1.0 - s)});
    }
  }
  return rule;
}

std::span<const TrianglePoint> degree4_rule() { return Degree4; }

std::span<const TrianglePoint> degree6_rule() { return Degree6; }

}  // namespace parmesan
