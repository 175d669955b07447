#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "adapt/expression.h"
#include "tests/fuzz/check.h"

namespace {

using parmesan::Expression;
using parmesan::Jet;
using parmesan::Point;

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void check_at(const Expression& expression, const Point& p) {
  const std::vector<double> extra{0.6, -0.8, 2.5};
  const Jet jet = expression.jet(p, extra);
  CHECK(same(jet.value, expression.value(p, extra)));
  if (expression.is_constant()) {
    CHECK(same(jet.value, expression.value(Point{}, extra)));
    for (const double derivative : {jet.x, jet.y, jet.xx, jet.xy, jet.yy})
      CHECK(!(derivative != 0.0) || std::isnan(derivative));
  }
}

}  // namespace

/// Any bytes are an expression whose jets have its values, or an ExpressionError within the text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const Expression expression = Expression::parse(text, {{"a", 0.5}, {"b", -2.0}}, {"nx", "ny", "exact"});
    CHECK(expression.text() == text);
    for (const Point& p : {Point{0.0, 0.0}, Point{0.3, -0.7}, Point{-1.0, 1.0}, Point{1e200, 1e-200}})
      check_at(expression, p);
  } catch (const parmesan::ExpressionError& error) {
    CHECK(error.position() <= size);
  }
  return 0;
}
