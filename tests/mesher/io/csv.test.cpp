#include "mesher/io/csv.h"

#include <catch2/catch.hpp>
#include <limits>

using parmesan::csv_line;

TEST_CASE("csv_line writes numbers to the last bit and leaves holes for the rest", "[mesher][io]") {
  CHECK(csv_line({}) == "\n");
  CHECK(csv_line({1, 0.1, -2.5e-300, std::monostate{}, std::string("text")}) == "1,0.1,-2.5e-300,,text\n");
  CHECK(csv_line({std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) == ",\n");
}

TEST_CASE("csv_line quotes texts that would break the row", "[mesher][io]") {
  CHECK(csv_line({std::string("a,b"), std::string("say \"x\""), std::string("two\nlines"), std::string()}) ==
        "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\",\n");
}

TEST_CASE("csv_line disarms texts that a spreadsheet would run", "[mesher][io]") {
  CHECK(csv_line({std::string("=1+1")}) == "'=1+1\n");
  CHECK(csv_line({std::string("@SUM(A1)"), std::string("+x"), std::string("-x")}) == "'@SUM(A1),'+x,'-x\n");
  CHECK(csv_line({std::string("\t=x"), std::string("=\"a\"")}) == "'\t=x,\"'=\"\"a\"\"\"\n");
  CHECK(csv_line({std::string("a=b"), -1.0}) == "a=b,-1\n");
}
