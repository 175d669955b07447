#include "mesher/mesh.h"

#include <catch2/catch.hpp>

using namespace parmesan;

TEST_CASE("label_name is the name, or the number in decimal", "[mesher][mesh]") {
  const LabelNames names{{1, "inlet"}, {-3, "wall"}};
  CHECK(label_name(names, 1) == "inlet");
  CHECK(label_name(names, -3) == "wall");
  CHECK(label_name(names, 12) == "12");
  CHECK(label_name({}, -7) == "-7");
}
