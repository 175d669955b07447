#pragma once

#include <cstddef>
#include <exception>
#include <limits>

namespace parmesan {

/// Calls f(0) ... f(count - 1) on the threads of OpenMP. The calls must not depend on one another: then neither the
/// results nor the exception, that of the smallest number that fails, depend on the threads.
template <class F>
void for_each_in_parallel(std::size_t count, F f) {
  std::exception_ptr failure;
  std::size_t failed = std::numeric_limits<std::size_t>::max();
#pragma omp parallel for schedule(static) if (count > 1000)
  for (std::size_t i = 0; i < count; ++i) {
    try {
      f(i);
    } catch (...) {
#pragma omp critical(parmesan_for_each_in_parallel)
      if (i < failed) {
        failed = i;
        failure = std::current_exception();
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace parmesan
