#include "adapt/region_names.h"

#include <catch2/catch.hpp>

using namespace parmesan;

TEST_CASE("regions are found by name, all that share it", "[adapt][case]") {
  Domain domain;
  domain.regions = {{{0.1, 0.1}, 7}, {{0.2, 0.2}, 3}, {{0.3, 0.3}, 7}, {{0.4, 0.4}, 4}};
  domain.region_names = {{3, "iron"}, {7, "iron"}, {9, "air"}};
  CHECK(region_names(domain) == std::vector<std::string>{"4", "air", "iron"});
  const RegionsByName regions = regions_by_name(domain);
  CHECK(regions.at("iron") == std::vector<int>{3, 7});
  std::vector<std::string> problems;
  const auto note = [&](std::size_t i, const std::string& problem) {
    problems.push_back(std::to_string(i) + ": " + problem);
  };
  CHECK(regions_named({"iron", "4"}, regions, note) == std::vector<int>{3, 7, 4});
  CHECK(problems.empty());
  CHECK(regions_named({"air", "irom", "glass"}, regions, note) == std::vector<int>{9});
  CHECK(problems == std::vector<std::string>{
                        "1: there is no region 'irom'; did you mean 'iron'? The regions are: '4', 'air', 'iron'",
                        "2: there is no region 'glass'. The regions are: '4', 'air', 'iron'"});
}
