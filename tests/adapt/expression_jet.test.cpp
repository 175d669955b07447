#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "adapt/expression.h"

namespace parmesan {
namespace {

/// A random expression that is smooth and of moderate size in [-1, 1]^2.
std::string random_expression(std::mt19937& engine, int depth) {
  const auto pick = [&engine](int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); };
  if (depth == 0)
    return std::vector<std::string>{"x", "y", "1.5", "(x+2*y)", "(0.3-x*y)"}[static_cast<std::size_t>(pick(5))];
  const std::string a = random_expression(engine, depth - 1);
  const std::string b = random_expression(engine, depth - 1);
  switch (pick(12)) {
    case 0:
      return "(" + a + "+" + b + ")";
    case 1:
      return "(" + a + "-" + b + ")";
    case 2:
      return "sin(" + a + ")*cos(" + b + ")";
    case 3:
      return "(" + a + ")/(2+tanh(" + b + "))";
    case 4:
      return "atan(" + a + ")";
    case 5:
      return "exp(sin(" + a + "))";
    case 6:
      return "(1.5+sin(" + a + "))^(1+cos(" + b + "))";
    case 7:
      return "hypot(1+cos(" + a + ")^2, " + b + ")";
    case 8:
      return "atan2(sin(" + a + "), 3+cos(" + b + "))";
    case 9:
      return "log(2+sin(" + a + "))*erf(" + b + ")";
    case 10:
      return "asin(0.9*sin(" + a + "))+acos(0.9*cos(" + b + "))";
    default:
      return "sqrt(1.1+sin(" + a + "))-asinh(" + b + ")";
  }
}

/// Two central differences, Richardson-extrapolated: O(h^4).
template <class F>
double slope(F f, double h) {
  const double coarse = (f(h) - f(-h)) / (2.0 * h);
  const double fine = (f(0.5 * h) - f(-0.5 * h)) / h;
  return (4.0 * fine - coarse) / 3.0;
}

}  // namespace

TEST_CASE("Jets of known functions have their textbook derivatives", "[adapt][expression]") {
  // u_x, u_y, u_xx, u_xy, u_yy written as expressions by hand: an oracle of the calculus, not of the engine.
  struct Known {
    std::string u, x, y, xx, xy, yy;
  };
  const std::vector<Known> known{
      {"x^3*y^2", "3*x^2*y^2", "2*x^3*y", "6*x*y^2", "6*x^2*y", "2*x^3"},
      {"exp(x*y)", "y*exp(x*y)", "x*exp(x*y)", "y^2*exp(x*y)", "(1 + x*y)*exp(x*y)", "x^2*exp(x*y)"},
      {"log(x)/y", "1/(x*y)", "-log(x)/y^2", "-1/(x^2*y)", "-1/(x*y^2)", "2*log(x)/y^3"},
      {"sin(x)*cosh(y)", "cos(x)*cosh(y)", "sin(x)*sinh(y)", "-sin(x)*cosh(y)", "cos(x)*sinh(y)", "sin(x)*cosh(y)"},
      {"hypot(x, y)", "x/sqrt(x*x+y*y)", "y/sqrt(x*x+y*y)", "y*y/(x*x+y*y)^1.5", "-x*y/(x*x+y*y)^1.5",
       "x*x/(x*x+y*y)^1.5"},
      {"atan2(y, x)", "-y/(x*x+y*y)", "x/(x*x+y*y)", "2*x*y/(x*x+y*y)^2", "(y*y-x*x)/(x*x+y*y)^2",
       "-2*x*y/(x*x+y*y)^2"},
      {"x^y", "y*x^(y-1)", "x^y*log(x)", "y*(y-1)*x^(y-2)", "x^(y-1)*(1+y*log(x))", "x^y*log(x)^2"},
      {"sqrt(x) - cbrt(y)", "0.5*x^-0.5", "-y^(-2/3)/3", "-0.25*x^-1.5", "0", "2/9*y^(-5/3)"},
  };
  const Point p{0.7, 1.3};
  for (const Known& k : known) {
    INFO(k.u);
    const Jet jet = Expression::parse(k.u).jet(p);
    const auto hand = [&p](const std::string& text) { return Approx(Expression::parse(text).value(p)).epsilon(1e-13); };
    CHECK(jet.value == Expression::parse(k.u).value(p));
    CHECK(jet.x == hand(k.x));
    CHECK(jet.y == hand(k.y));
    CHECK(jet.xx == hand(k.xx));
    CHECK(jet.xy == hand(k.xy));
    CHECK(jet.yy == hand(k.yy));
  }
}

TEST_CASE("Jets are exact for powers at 0 and for negative bases", "[adapt][expression]") {
  const Jet square = Expression::parse("x^2").jet({0.0, 0.0});
  CHECK(square.value == 0.0);
  CHECK(square.x == 0.0);
  CHECK(square.xx == 2.0);
  const Jet cube = Expression::parse("pow(x, 3)").jet({-2.0, 0.0});
  CHECK(cube.value == -8.0);
  CHECK(cube.x == 12.0);
  CHECK(cube.xx == -12.0);
  const Jet inverse = Expression::parse("x^-2").jet({-0.5, 0.0});
  CHECK(inverse.value == 4.0);
  CHECK(inverse.x == 16.0);
  CHECK(inverse.xx == 96.0);
  CHECK(Expression::parse("x^1").jet({0.0, 0.0}).x == 1.0);
  CHECK(Expression::parse("x^1").jet({0.0, 0.0}).xx == 0.0);
  CHECK(Expression::parse("x^0").jet({0.0, 0.0}).xx == 0.0);
}

TEST_CASE("Jets stay finite where a singular slope meets an argument that does not vary", "[adapt][expression]") {
  const Jet tip = Expression::parse("hypot(x, y)").jet({0.0, 0.0});
  CHECK((tip.value == 0.0 && tip.x == 0.0 && tip.y == 0.0 && tip.xx == 0.0 && tip.yy == 0.0));
  const Jet root = Expression::parse("sqrt(n) + x", {}, {"n"}).jet({1.0, 0.0}, {0.0});
  CHECK((root.x == 1.0 && root.xx == 0.0));
  const Jet edge = Expression::parse("max(x, 0)").jet({-1.0, 0.0});
  CHECK((edge.value == 0.0 && edge.x == 0.0));
}

TEST_CASE("Jets keep their digits in the tails of layers", "[adapt][expression]") {
  // d tanh(s) = 4 e^(-2s) (1 - 2 e^(-2s) + ...) for large s.
  const double s = 15.0;
  const Jet jet = Expression::parse("tanh(x)").jet({s, 0.0});
  CHECK(jet.x == Approx(4.0 * std::exp(-2.0 * s) * (1.0 - 2.0 * std::exp(-2.0 * s))).epsilon(1e-12));
  CHECK(jet.xx == Approx(-8.0 * std::exp(-2.0 * s)).epsilon(1e-12));
  CHECK(Expression::parse("tanh(x)").jet({1000.0, 0.0}).xx == 0.0);
}

TEST_CASE("Jets obey the product, quotient and chain rules for any operands", "[adapt][expression]") {
  const Point p{0.37, -0.81};
  const std::vector<std::string> operands{"sin(3*x+y)", "exp(x*y)-2", "atan(5*(x-y))", "1+x^2*y", "tanh(x)*y"};
  for (const std::string& a : operands) {
    for (const std::string& b : operands) {
      const auto jet = [&p](const std::string& text) { return Expression::parse(text).jet(p); };
      const std::string quotient = "((" + a + ")/(" + b + "))*(" + b + ")";
      CHECK(jet(quotient).xy == Approx(jet(a).xy).epsilon(1e-12).margin(1e-12));
      const std::string log_sum = "exp(log((" + a + ")^2) + log((" + b + ")^2))";
      const std::string product = "((" + a + ")*(" + b + "))^2";
      CHECK(jet(log_sum).xx == Approx(jet(product).xx).epsilon(1e-11).margin(1e-12));
      CHECK(jet(log_sum).y == Approx(jet(product).y).epsilon(1e-11).margin(1e-12));
    }
  }
}

TEST_CASE("Jets of random expressions agree with finite differences", "[adapt][expression]") {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> coordinate(-0.9, 0.9);
  for (int i = 0; i < 400; ++i) {
    const std::string text = random_expression(engine, 3);
    const Expression e = Expression::parse(text);
    const Point p{coordinate(engine), coordinate(engine)};
    const Jet jet = e.jet(p);
    INFO(text << " at " << p.x << ", " << p.y);
    const double scale =
        1.0 + std::abs(jet.xx) + std::abs(jet.xy) + std::abs(jet.yy) + std::abs(jet.x) + std::abs(jet.y);
    const auto close = [scale](double expected) { return Approx(expected).margin(2e-7 * scale).epsilon(0.0); };
    const double h = 1e-3;
    CHECK(e.value(p) == jet.value);
    CHECK(jet.x == close(slope([&](double t) { return e.value({p.x + t, p.y}); }, h)));
    CHECK(jet.y == close(slope([&](double t) { return e.value({p.x, p.y + t}); }, h)));
    CHECK(jet.xx == close(slope([&](double t) { return e.jet({p.x + t, p.y}).x; }, h)));
    CHECK(jet.xy == close(slope([&](double t) { return e.jet({p.x, p.y + t}).x; }, h)));
    CHECK(jet.yy == close(slope([&](double t) { return e.jet({p.x, p.y + t}).y; }, h)));
  }
}

TEST_CASE("Every function of one argument has the derivatives of finite differences", "[adapt][expression]") {
  const std::vector<std::string> functions{"sqrt",  "cbrt", "exp",  "log",  "log10", "log2", "sin",  "cos",
                                           "tan",   "asin", "acos", "atan", "sinh",  "cosh", "tanh", "asinh",
                                           "atanh", "erf",  "abs",  "sign", "floor", "ceil", "round"};
  for (const std::string& name : functions) {
    INFO(name);
    const Expression e = Expression::parse(name + "(x)");
    const double x = 0.4;
    CHECK(e.jet({x, 0.0}).x == Approx(slope([&](double t) { return e.value({x + t, 0.0}); }, 1e-3)).epsilon(1e-9));
    CHECK(e.jet({x, 0.0}).xx == Approx(slope(
                                           [&](double t) {
                                             return e.jet({x + t, 0.0}).x;
                                           },
                                           1e-3))
                                    .epsilon(1e-9)
                                    .margin(1e-12));
  }
  const Expression e = Expression::parse("acosh(x)");
  CHECK(e.jet({1.5, 0.0}).xx == Approx(slope([&](double t) { return e.jet({1.5 + t, 0.0}).x; }, 1e-3)).epsilon(1e-9));
}

TEST_CASE("An expression of another variable has its derivative by that", "[adapt][expression]") {
  const Expression e = Expression::parse("r*sin(t) + t^2", {{"r", 3.0}}, {}, {"t"});
  CHECK(e.value({0.4, 0.0}) == Approx(3.0 * std::sin(0.4) + 0.16).epsilon(1e-15));
  CHECK(e.jet({0.4, 0.0}).x == Approx(3.0 * std::cos(0.4) + 0.8).epsilon(1e-14));
  CHECK_THROWS_AS(Expression::parse("x + t", {}, {}, {"t"}), ExpressionError);
}

}  // namespace parmesan
