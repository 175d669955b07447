#include "mesher/geometry/hilbert.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace parmesan {

namespace {

/// One level of the curve: cell (2 x_bit + y_bit) of a square in the given pose has this position
/// along the curve, and its own pose. Poses: 0 starts lower left and ends lower right, 1 is 0
/// mirrored at the diagonal, 2 is 0 turned by half a turn, 3 is 1 turned by half a turn.
struct Step {
  std::uint8_t position;
  std::uint8_t pose;
};
constexpr std::array<std::array<Step, 4>, 4> steps{{
    {{{0, 1}, {1, 0}, {3, 3}, {2, 0}}},
    {{{0, 0}, {3, 2}, {1, 1}, {2, 1}}},
    {{{2, 2}, {3, 1}, {1, 2}, {0, 3}}},
    {{{2, 3}, {1, 3}, {3, 0}, {0, 2}}},
}};

/// Four levels at once: cell (16 x + y) of 16 x 16 in a square of the given pose.
constexpr Step four_steps(std::size_t pose, std::size_t cell) {
  std::size_t position = 0;
  for (std::size_t bit = 4; bit-- > 0;) {
    const Step step = steps[pose][(cell >> (bit + 4) & 1U) << 1 | (cell >> bit & 1U)];
    position = position << 2 | step.position;
    pose = step.pose;
  }
  return {static_cast<std::uint8_t>(position), static_cast<std::uint8_t>(pose)};
}

constexpr std::array<std::array<Step, 256>, 4> steps_of_four = [] {
  std::array<std::array<Step, 256>, 4> result{};
  for (std::size_t pose = 0; pose < 4; ++pose)
    for (std::size_t cell = 0; cell < 256; ++cell) result[pose][cell] = four_steps(pose, cell);
  return result;
}();

std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0;
  std::size_t pose = 0;
  for (int shift = 12; shift >= 0; shift -= 4) {
    const Step step = steps_of_four[pose][(x >> shift & 15U) << 4 | (y >> shift & 15U)];
    key = key << 8 | step.position;
    pose = step.pose;
  }
  return key;
}

struct Keyed {
  std::uint32_t key;
  int index;
};

std::vector<Keyed> keyed(std::span<const Point> points) {
  Point low = points[0];
  Point high = points[0];
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  // Halved before they are subtracted, so that the largest doubles do not overflow.
  const double half_size = std::max(0.5 * high.x - 0.5 * low.x, 0.5 * high.y - 0.5 * low.y);
  const auto cell = [half_size](double coordinate, double least) {
    if (half_size == 0.0) return 0U;
    return static_cast<std::uint32_t>(65535.0 * std::min(1.0, (0.5 * coordinate - 0.5 * least) / half_size));
  };
  std::vector<Keyed> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    result[i] = {hilbert_key(cell(points[i].x, low.x), cell(points[i].y, low.y)), static_cast<int>(i)};
  }
  return result;
}

/// Stable sort by one digit of 11 bits.
std::vector<Keyed> sorted_by_digit(const std::vector<Keyed>& items, int shift) {
  const auto digit = [shift](const Keyed& item) { return item.key >> shift & 2047U; };
  std::array<std::size_t, 2049> first{};
  for (const Keyed& item : items) ++first[digit(item) + 1];
  for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
  std::vector<Keyed> result(items.size());
  for (const Keyed& item : items) result[first[digit(item)]++] = item;
  return result;
}

}  // namespace

std::vector<int> hilbert_order(std::span<const Point> points) {
  if (points.empty()) return {};
  std::vector<Keyed> items = keyed(points);
  for (const int shift : {0, 11, 22}) items = sorted_by_digit(items, shift);
  std::vector<int> order(points.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].index;
  return order;
}

}  // namespace parmesan
