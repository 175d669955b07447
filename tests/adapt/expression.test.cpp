#include "adapt/expression.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string>

namespace parmesan {
namespace {

double at_origin(const std::string& text) { return Expression::parse(text).value({0.0, 0.0}); }

std::string message_of(const std::string& text, const std::map<std::string, double>& symbols = {}) {
  try {
    Expression::parse(text, symbols);
  } catch (const ExpressionError& error) {
    return std::to_string(error.position()) + ": " + error.what();
  }
  return "";
}

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

}  // namespace

TEST_CASE("Expression binds its operators as mathematics does", "[adapt][expression]") {
  CHECK(at_origin("1 + 2*3") == 7.0);
  CHECK(at_origin("10 - 4 - 3") == 3.0);
  CHECK(at_origin("16/4/2") == 2.0);
  CHECK(at_origin("2^3^2") == 512.0);
  CHECK(at_origin("-2^2") == -4.0);
  CHECK(at_origin("2^-1") == 0.5);
  CHECK(at_origin("--3") == 3.0);
  CHECK(at_origin("(1 + 2)*3") == 9.0);
  CHECK(at_origin("1 < 2 && 2 < 3 || 0") == 1.0);
  CHECK(at_origin("0 && 0 || 1") == 1.0);
  CHECK(at_origin("1 || 0 && 0") == 1.0);
  CHECK(at_origin("!0 + 1") == 2.0);
  CHECK(at_origin("1 == 1.0") == 1.0);
  CHECK(at_origin("3 != 3") == 0.0);
  CHECK(at_origin("3 >= 3") + at_origin("3 > 3") == 1.0);
  CHECK(at_origin(" .5e1\t+\n1. ") == 6.0);
  CHECK(at_origin("max(1, 5, 3) - min(4, 2, 3)") == 3.0);
  CHECK(at_origin("pi") == std::numbers::pi);
}

TEST_CASE("Expression nests ?: to the right and skips what is not taken", "[adapt][expression]") {
  const Expression steps = Expression::parse("x < 0 ? 1 : x < 1 ? 2 : 3 + 10");
  CHECK(steps.value({-1.0, 0.0}) == 1.0);
  CHECK(steps.value({0.5, 0.0}) == 2.0);
  CHECK(steps.value({2.0, 0.0}) == 13.0);
  CHECK(Expression::parse("(x > 0 ? 1 : 2) + 3").value({1.0, 0.0}) == 4.0);
  CHECK(Expression::parse("2^(x > 0 ? 3 : 2)").value({1.0, 0.0}) == 8.0);
  const Jet guarded = Expression::parse("x > 0 ? sqrt(x) : 0").jet({-1.0, 0.0});
  CHECK(guarded.value == 0.0);
  CHECK(guarded.xx == 0.0);
}

TEST_CASE("Expression knows parameters and extra variables by name", "[adapt][expression]") {
  const Expression e = Expression::parse("alpha*nx + x^exact", {{"alpha", 20.0}}, {"nx", "ny", "exact"});
  CHECK(e.value({2.0, 0.0}, {0.5, 7.0, 3.0}) == 18.0);
  CHECK(e.uses("nx"));
  CHECK_FALSE(e.uses("ny"));
  CHECK(e.uses("exact"));
  CHECK_FALSE(e.uses("alpha"));
  CHECK_FALSE(e.is_constant());
  CHECK(Expression::parse("alpha^2 + sin(1)", {{"alpha", 20.0}}).is_constant());
  CHECK_FALSE(Expression::parse("0*x").is_constant());
  CHECK(Expression::parse(" x ").text() == " x ");
  CHECK(Expression::constant(0.1).value({0.0, 0.0}) == 0.1);
  CHECK(Expression::constant(0.1).text() == "0.1");
}

TEST_CASE("Expression names the mistake, its place and the nearest right name", "[adapt][expression][errors]") {
  CHECK(message_of("alfa*x", {{"alpha", 1.0}}) ==
        "0: unknown name 'alfa'; did you mean 'alpha'? Allowed here: 'x', 'y', 'pi', 'alpha' and functions such as "
        "sqrt, exp, sin");
  CHECK_THAT(message_of("1 + sqr(x)"), Catch::StartsWith("4: unknown function 'sqr'; did you mean 'sqrt'?"));
  CHECK(message_of("2x") == "1: an operator is missing before 'x'");
  CHECK(message_of("x = 1") == "2: '=' is not an operator; to compare write '=='");
  CHECK(message_of("x**2") == "1: '**' is not an operator; write '^' for powers");
  CHECK(message_of("0 < x < 1") == "6: comparisons cannot be chained; write a < b && b < c");
  CHECK(message_of("atan2(x)") == "0: the function atan2 takes 2 arguments, 1 given");
  CHECK(message_of("sin(x, y)") == "0: the function sin takes 1 argument, 2 given");
  CHECK(message_of("max(x)") == "0: the function max takes 2 or more arguments, 1 given");
  CHECK(message_of("sin x") == "4: the function sin needs its arguments in parentheses");
  CHECK(message_of("x(1)") == "0: 'x' is not a function");
  CHECK(message_of("(x") == "2: ')' expected to close '(', found the end");
  CHECK(message_of("x)") == "1: ')' has no matching '('");
  CHECK(message_of("x ? 1") == "5: ':' expected between the two choices of '?', found the end");
  CHECK(message_of("x +") == "3: the expression ends where a value is expected");
  CHECK(message_of("") == "0: the expression is empty");
  CHECK(message_of("x + #") == "4: '#' is not allowed in an expression");
  CHECK(message_of("1e999") == "0: the number 1e999 is too large or too small for double precision");
  CHECK(message_of("sin()") == "4: the function sin needs an argument");
}

TEST_CASE("Expression refuses bombs quickly and keeps what fits", "[adapt][expression][errors]") {
  const std::string deep = "nested more than 200 deep";
  CHECK_THAT(message_of(repeated("(", 20000) + "x" + repeated(")", 20000)), Catch::Contains("longer than 10000"));
  CHECK_THAT(message_of(repeated("(", 300) + "x" + repeated(")", 300)), Catch::Contains(deep));
  CHECK_THAT(message_of(repeated("-", 9000) + "x"), Catch::Contains(deep));
  CHECK_THAT(message_of(repeated("x^", 4000) + "x"), Catch::Contains(deep));
  CHECK_THAT(message_of(repeated("x?1:", 2000) + "x"), Catch::Contains(deep));
  CHECK_THAT(message_of(repeated("sin(", 2000)), Catch::Contains(deep));
  CHECK_THAT(message_of(repeated("1||1&&1==1<1+1*(", 190) + "x" + repeated(")", 190)), Catch::Contains("nested"));
  CHECK_THAT(message_of(std::string(1000000, '1')), Catch::Contains("too large"));
  CHECK_THAT(message_of(std::string(1000000, 'a')), Catch::Contains("unknown name"));
  CHECK(message_of(repeated("(", 200) + "x" + repeated(")", 200)).empty());
  CHECK(Expression::parse(repeated("(1+x*", 199) + "x" + repeated(")", 199)).value({0.0, 0.0}) == 1.0);
  CHECK(Expression::parse(repeated("x+", 4999) + "x").jet({1.0, 0.0}).x == 5000.0);
  CHECK(std::isinf(at_origin("9^9^9^9")));
}

TEST_CASE("The longest expressions are compiled and evaluated in time", "[adapt][expression][errors]") {
  const auto cpu_seconds = [](const auto& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  const std::string longest = repeated("pow(x,y)^y*", 1111) + "1";  // 10 000 tokens
  const Expression expression = Expression::parse(longest);
  CHECK(cpu_seconds([&] { Expression::parse(longest); }) < 0.5);
  CHECK(cpu_seconds([&] { expression.jet({1.5, 0.5}); }) < 0.1);
  CHECK(cpu_seconds([] { message_of(repeated("sin(x+", 170000)); }) < 0.5);
  CHECK(cpu_seconds([] { message_of(repeated("x?y:", 250000)); }) < 0.5);
}

TEST_CASE("Expression gives inf or nan, never a wrong number, where no value exists", "[adapt][expression]") {
  CHECK(std::isinf(at_origin("1/0")));
  CHECK(std::isnan(at_origin("0/0")));
  CHECK(std::isnan(at_origin("sqrt(-1)")));
  CHECK(std::isnan(Expression::parse("max(x/y, 1)").value({0.0, 0.0})));
  CHECK(std::isnan(Expression::parse("min(1, x/y)").jet({0.0, 0.0}).value));
  CHECK(std::isnan(Expression::parse("max(x/y, 1)").jet({0.0, 0.0}).value));
}

}  // namespace parmesan
