#pragma once

#include <cstdint>
#include <string>

#include "mesher/geometry/domain.h"

namespace parmesan::support {

struct HardPolygon {
  std::string name;
  Domain domain;
};

/// Polygons that are valid but hard on a mesher, a different one for each number: random simple ones,
/// Koch curves, combs and stars with gaps and tip angles down to 2^-40, grids of cocircular points,
/// chains that bend by units in the last place, nested rings. Turned, scaled and moved at random where that
/// keeps them valid. Labels are 1, 2, ...
HardPolygon hard_polygon(std::uint32_t number);

}  // namespace parmesan::support
