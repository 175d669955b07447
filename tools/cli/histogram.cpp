#include "tools/cli/histogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/cli/results.h"

namespace parmesan {
namespace {

std::string padded(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

}  // namespace

Histogram histogram(std::span<const double> values, std::vector<double> bounds) {
  Histogram result{std::move(bounds), {}};
  result.counts.assign(result.bounds.size() - 1, 0);
  const auto inner_begin = result.bounds.begin() + 1;
  const auto inner_end = result.bounds.end() - 1;
  for (const double value : values) {
    const auto bin = std::upper_bound(inner_begin, inner_end, value) - inner_begin;
    ++result.counts[static_cast<std::size_t>(bin)];
  }
  return result;
}

std::vector<double> linear_bounds(double low, double high, int n) {
  std::vector<double> bounds;
  for (int i = 0; i <= n; ++i) bounds.push_back(low + (high - low) * i / n);
  return bounds;
}

std::vector<double> geometric_bounds(double low, double high, int n) {
  std::vector<double> bounds;
  for (int i = 0; i <= n; ++i) bounds.push_back(low * std::pow(high / low, static_cast<double>(i) / n));
  return bounds;
}

std::string text(const Histogram& histogram) {
  constexpr long width = 50;
  const long total = std::max(1L, std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0L));
  const long largest = histogram.counts.empty() ? 1 : std::max(1L, *std::ranges::max_element(histogram.counts));
  std::string lines;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const long count = histogram.counts[i];
    const double percent = 100.0 * static_cast<double>(count) / static_cast<double>(total);
    lines += padded(format_number(histogram.bounds[i], 3), 10) + padded(format_number(histogram.bounds[i + 1], 3), 10) +
             padded(format_number(percent, 3), 10) + " %  " +
             std::string(static_cast<std::size_t>((count * width + largest - 1) / largest), '#') + "\n";
  }
  return lines;
}

}  // namespace parmesan
