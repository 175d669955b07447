#include "mesher/geometry/hilbert.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "mesher/index.h"

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

/// The square around the points, its half size 0 when they all are the same. Halved before they are
/// subtracted, so that the largest doubles do not overflow.
struct Square {
  Point low;
  double half_size;
};

Square square_around(std::span<const Point> points) {
  Point low = points[0];
  Point high = points[0];
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {low, std::max(0.5 * high.x - 0.5 * low.x, 0.5 * high.y - 0.5 * low.y)};
}

std::vector<Keyed> keyed(std::span<const Point> points, const Square& square) {
  const auto cell = [&square](double coordinate, double least) {
    const double share = (0.5 * coordinate - 0.5 * least) / square.half_size;
    return static_cast<std::uint32_t>(65535.0 * std::min(1.0, share));
  };
  std::vector<Keyed> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [x, y] = points[i];
    result[i] = {hilbert_key(cell(x, square.low.x), cell(y, square.low.y)), static_cast<int>(i)};
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

std::vector<Keyed> sorted(std::vector<Keyed> items) {
  constexpr std::size_t fewer_than_digits = 2048;
  if (items.size() < fewer_than_digits)
    std::ranges::stable_sort(items, {}, &Keyed::key);
  else
    for (const int shift : {0, 11, 22}) items = sorted_by_digit(items, shift);
  return items;
}

/// Brings the points of one cell into the order of a curve of their own.
void order_within_cell(std::span<const Point> points, std::span<int> cell) {
  std::vector<Point> inside(cell.size());
  for (std::size_t i = 0; i < cell.size(); ++i) inside[i] = points[at(cell[i])];
  std::vector<int> order = hilbert_order(inside);
  for (int& i : order) i = cell[at(i)];
  std::ranges::copy(order, cell.begin());
}

}  // namespace

std::vector<int> hilbert_order(std::span<const Point> points) {
  constexpr std::size_t many_in_cell = 16;
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  if (points.empty()) return order;
  const Square square = square_around(points);
  if (!(square.half_size > 0.0)) return order;
  const std::vector<Keyed> items = sorted(keyed(points, square));
  std::size_t first = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    order[i] = items[i].index;
    if (i + 1 < items.size() && items[i + 1].key == items[i].key) continue;
    const std::size_t count = i + 1 - first;
    if (count >= many_in_cell) order_within_cell(points, std::span(order).subspan(first, count));
    first = i + 1;
  }
  return order;
}

}  // namespace parmesan
