#include "mesher/io/tag_map.h"

#include <catch2/catch.hpp>
#include <limits>

using parmesan::TagMap;

namespace {

TagMap map_of(const std::vector<std::int64_t>& tags, bool unique = true) {
  TagMap map;
  for (const std::int64_t tag : tags) map.add(tag);
  CHECK(map.finish() == unique);
  return map;
}

}  // namespace

TEST_CASE("Tags are found by their places, whatever their order and gaps", "[mesher][io]") {
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  const std::vector<std::int64_t> tags =
      GENERATE(std::vector<std::int64_t>{}, std::vector<std::int64_t>{5}, std::vector<std::int64_t>{3, 4, 5},
               std::vector<std::int64_t>{4, 3, 5}, std::vector<std::int64_t>{9, 0, largest, 2});
  const TagMap map = map_of(tags);
  for (std::size_t i = 0; i < tags.size(); ++i) CHECK(map.index(tags[i]) == static_cast<int>(i));
  for (const std::int64_t absent : {std::int64_t{-1}, std::int64_t{1}, std::int64_t{6}, largest - 1}) {
    CHECK(map.index(absent) == -1);
  }
}

TEST_CASE("A tag that comes twice is noticed", "[mesher][io]") {
  map_of({1, 2, 2}, false);
  map_of({7, 7}, false);
  map_of({2, 1, 5, 1}, false);
}
