#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <vector>

#include "mesher/index.h"

namespace parmesan {

/// Calls f(0) ... f(n - 1) on the threads of OpenMP. The calls must not depend on one another: then
/// neither the result nor the exception, that of the smallest number that fails, depends on the threads.
template <class F>
void parallel_for(int n, F f) {
  std::exception_ptr failure;
  int failed = n;
#pragma omp parallel for schedule(dynamic) if (n > 1)
  for (int i = 0; i < n; ++i) {
    try {
      f(i);
    } catch (...) {
#pragma omp critical(parmesan_parallel_for)
      if (i < failed) {
        failed = i;
        failure = std::current_exception();
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
}

/// The same for many short calls: a block of them at a time.
template <class F>
void for_each_in_parallel(std::size_t count, F f) {
  constexpr std::size_t length = 256;
  parallel_for(static_cast<int>((count + length - 1) / length), [&](int block) {
    const std::size_t first = static_cast<std::size_t>(block) * length;
    for (std::size_t i = first; i < std::min(count, first + length); ++i) f(i);
  });
}

/// Numbers 0 ... size - 1 cut into ranges of a fixed length, so that what is done range by range does
/// not depend on the number of threads.
class Ranges {
 public:
  explicit Ranges(std::size_t size) : size_(size) {}
  int count() const { return static_cast<int>((size_ + length - 1) / length); }
  std::size_t first(int range) const { return static_cast<std::size_t>(range) * length; }
  std::size_t last(int range) const { return std::min(size_, first(range) + length); }

 private:
  static constexpr std::size_t length = 16384;
  std::size_t size_;
};

/// All elements, list by list.
template <class T>
std::vector<T> joined(const std::vector<std::vector<T>>& lists) {
  std::vector<T> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// What f(first, last, found) appends to found for each range, one range after the other.
template <class T, class F>
std::vector<T> collect(std::size_t size, F f) {
  const Ranges ranges(size);
  std::vector<std::vector<T>> of_range(static_cast<std::size_t>(ranges.count()));
  parallel_for(ranges.count(), [&](int i) { f(ranges.first(i), ranges.last(i), of_range[at(i)]); });
  return joined(of_range);
}

}  // namespace parmesan
