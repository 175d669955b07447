#include "adapt/nearest_name.h"

#include <catch2/catch.hpp>
#include <random>

namespace parmesan {

TEST_CASE("edit_distance is a metric", "[adapt][names]") {
  CHECK(edit_distance("kitten", "sitting") == 3);  // Levenshtein's textbook example
  CHECK(edit_distance("", "abc") == 3);
  std::mt19937 engine(3);
  const auto word = [&engine] {
    std::string text;
    for (auto i = engine() % 6; i > 0; --i) text += static_cast<char>('a' + engine() % 3);
    return text;
  };
  for (int i = 0; i < 500; ++i) {
    const std::string a = word();
    const std::string b = word();
    const std::string c = word();
    CHECK((edit_distance(a, b) == 0) == (a == b));
    CHECK(edit_distance(a, b) == edit_distance(b, a));
    CHECK(edit_distance(a, c) <= edit_distance(a, b) + edit_distance(b, c));
    CHECK(edit_distance(a + c, b + c) <= edit_distance(a, b));
  }
}

TEST_CASE("nearest_name finds slips and leaves other words alone", "[adapt][names]") {
  const std::vector<std::string> names{"l2_error", "h1_error", "vertices", "max_vertices"};
  CHECK(nearest_name("l2_eror", names) == "l2_error");
  CHECK(nearest_name("L2_ERROR", names) == "l2_error");
  CHECK(nearest_name("vertexes", names) == "vertices");
  CHECK(nearest_name("max", names) == "max_vertices");
  CHECK(nearest_name("L2", names).empty());
  CHECK(nearest_name("ver", std::vector<std::string>{"vertices", "vertical"}).empty());
  CHECK(nearest_name("banana", names).empty());
  CHECK(nearest_name(std::string(1000000, 'v'), names).empty());
  CHECK(suggestion("banana", names).empty());
  CHECK(suggestion("vertice", names) == "; did you mean 'vertices'?");
  CHECK(quoted_list(names) == "'l2_error', 'h1_error', 'vertices', 'max_vertices'");
  CHECK(quoted_list({}) == "(none)");
}

}  // namespace parmesan
