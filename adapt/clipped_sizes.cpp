#include "adapt/clipped_sizes.h"

#include <algorithm>

namespace parmesan {

void Clipped::add(const Point& p) {
  low = count == 0 ? p : Point{std::min(low.x, p.x), std::min(low.y, p.y)};
  high = count == 0 ? p : Point{std::max(high.x, p.x), std::max(high.y, p.y)};
  ++count;
}

}  // namespace parmesan
