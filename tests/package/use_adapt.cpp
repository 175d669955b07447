// Compiles an expression: enough to see that parmesan::adapt links and works.
#include <adapt/case_schema.h>
#include <adapt/expression.h>

#include <iostream>

int main() {
  const double value = parmesan::Expression::parse("2*x + y").value({3.0, 1.0});
  std::cout << value << "\n" << parmesan::case_schema().size() << " keys in the schema\n";
  return value == 7.0 ? 0 : 1;
}
