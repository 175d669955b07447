#include "tools/cli/large_arrays.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>

// The arrays of a mesh come and go many times. Where freed ones stay in the heap, a million vertices take 8 % more
// memory. Given back they must be mapped anew: page by page that is 8 % of the time, in pages of 2 MB less than what
// these spare.
#if defined(__GLIBC__) && !defined(PARMESAN_SANITIZE)
#include <malloc.h>
#include <sys/mman.h>

namespace {

constexpr std::size_t large = 1 << 22;
constexpr std::size_t large_page = 1 << 21;

void* allocate(std::size_t size) {
  if (size < large) return std::malloc(std::max<std::size_t>(size, 1));
  void* const array = memalign(large_page, size);
  if (array != nullptr) madvise(array, size, MADV_HUGEPAGE);  // where the system has none, pages are small
  return array;
}

}  // namespace

// Not inlined, lest compilers take one for what does not go with the other.
[[gnu::noinline]] void* operator new(std::size_t size) {
  while (true) {
    if (void* const array = allocate(size)) return array;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

[[gnu::noinline]] void operator delete(void* array) noexcept { std::free(array); }
[[gnu::noinline]] void operator delete(void* array, std::size_t) noexcept { std::free(array); }

void give_back_large_arrays() {
  mallopt(M_MMAP_THRESHOLD, static_cast<int>(large));
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}
#else
void give_back_large_arrays() {}
#endif
