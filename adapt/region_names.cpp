#include "adapt/region_names.h"

#include <utility>

#include "adapt/nearest_name.h"

namespace parmesan {
namespace {

std::vector<std::string> names_of(const RegionsByName& regions) {
  std::vector<std::string> names;
  names.reserve(regions.size());
  for (const auto& [name, numbers] : regions) names.push_back(name);
  return names;
}

}  // namespace

RegionsByName regions_by_name(const LabelNames& names, std::vector<int> numbers) {
  RegionsByName by_name;
  for (const int number : ascending(std::move(numbers))) by_name[label_name(names, number)].push_back(number);
  return by_name;
}

RegionsByName regions_by_name(const Domain& domain) {
  std::vector<int> numbers;
  for (const auto& entry : domain.region_names) numbers.push_back(entry.first);
  for (const RegionSeed& seed : domain.regions) numbers.push_back(seed.region);
  return regions_by_name(domain.region_names, std::move(numbers));
}

std::vector<std::string> region_names(const Domain& domain) { return names_of(regions_by_name(domain)); }

std::vector<int> regions_named(const std::vector<std::string>& names, const RegionsByName& regions,
                               const std::function<void(std::size_t, const std::string&)>& unknown) {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = regions.find(names[i]);
    if (found != regions.end()) {
      numbers.insert(numbers.end(), found->second.begin(), found->second.end());
      continue;
    }
    const std::vector<std::string> known = names_of(regions);
    const std::string hint = suggestion(names[i], known);
    unknown(i, "there is no region '" + names[i].substr(0, 60) + "'" + (hint.empty() ? "." : hint) +
                   " The regions are: " + quoted_list(known));
  }
  return numbers;
}

}  // namespace parmesan
