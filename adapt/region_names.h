#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The numbers of the regions that have each name, ascending; several may share one.
using RegionsByName = std::map<std::string, std::vector<int>>;

RegionsByName regions_by_name(const LabelNames& names, std::vector<int> numbers);
RegionsByName regions_by_name(const Domain& domain);

/// The names, in the order of bytes.
std::vector<std::string> region_names(const Domain& domain);

/// The numbers of the regions with these names. Where no region has the i-th, calls unknown(i, what to say of it).
std::vector<int> regions_named(const std::vector<std::string>& names, const RegionsByName& regions,
                               const std::function<void(std::size_t, const std::string&)>& unknown);

}  // namespace parmesan
