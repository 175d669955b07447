#include "tools/cli/histogram_text.h"

#include <algorithm>
#include <numeric>

#include "adapt/number_text.h"
#include "tools/cli/results.h"

namespace parmesan {

std::string text(const Histogram& histogram) {
  constexpr long width = 50;
  const long total = std::max(1L, std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0L));
  const long largest = histogram.counts.empty() ? 1 : std::max(1L, *std::ranges::max_element(histogram.counts));
  std::string lines;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const long count = histogram.counts[i];
    const double percent = 100.0 * static_cast<double>(count) / static_cast<double>(total);
    lines += padded(short_number(histogram.bounds[i], 3), 10) + padded(short_number(histogram.bounds[i + 1], 3), 10) +
             padded(short_number(percent, 3), 10) + " %  " +
             std::string(static_cast<std::size_t>((count * width + largest - 1) / largest), '#') + "\n";
  }
  return lines;
}

}  // namespace parmesan
