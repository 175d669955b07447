#include "fem/quadrature.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace parmesan {
namespace {

double factorial(int n) { return n <= 1 ? 1.0 : n * factorial(n - 1); }

/// Mean over a triangle of l0^a l1^b l2^c = 2 a! b! c! / (a + b + c + 2)! (closed form).
double mean_of_monomial(int a, int b, int c) {
  return 2.0 * factorial(a) * factorial(b) * factorial(c) / factorial(a + b + c + 2);
}

void check_degree(std::span<const TrianglePoint> rule, int degree) {
  for (int a = 0; a <= degree; ++a) {
    for (int b = 0; a + b <= degree; ++b) {
      const int c = degree - a - b;
      double sum = 0.0;
      for (const auto& [l, w] : rule) sum += w * std::pow(l[0], a) * std::pow(l[1], b) * std::pow(l[2], c);
      CHECK(sum == Approx(mean_of_monomial(a, b, c)).epsilon(1e-12));
    }
  }
}

bool strictly_inside(std::span<const TrianglePoint> rule) {
  return std::ranges::all_of(
      rule, [](const TrianglePoint& p) { return std::ranges::all_of(p.lambda, [](double l) { return l > 1e-3; }); });
}

}  // namespace

TEST_CASE("triangle rules integrate monomials of their degree", "[fem][quadrature]") {
  check_degree(degree4_rule(), 4);
  check_degree(degree6_rule(), 6);
  check_degree(conical_rule(6), 10);
  check_degree(conical_rule(3), 4);
}

TEST_CASE("quadrature points are inside the triangle, weights positive", "[fem][quadrature]") {
  CHECK(strictly_inside(degree4_rule()));
  CHECK(strictly_inside(degree6_rule()));
  CHECK(strictly_inside(conical_rule(6)));
  CHECK(conical_rule(6).size() == 36);
  CHECK(std::ranges::all_of(conical_rule(6), [](const TrianglePoint& p) { return p.weight > 0.0; }));
}

TEST_CASE("gauss_rule(n) integrates t^(2n-1) and not t^(2n)", "[fem][quadrature]") {
  const int n = GENERATE(1, 2, 3, 4, 6, 10);
  const auto integral = [n](int power) {
    double sum = 0.0;
    for (const auto& [t, w] : gauss_rule(n)) sum += w * std::pow(t, power);
    return sum;
  };
  for (int k = 0; k < 2 * n; ++k) CHECK(integral(k) == Approx(1.0 / (k + 1)).epsilon(1e-13));
  CHECK(std::abs(integral(2 * n) - 1.0 / (2 * n + 1)) > 1e-14);
}

}  // namespace parmesan
