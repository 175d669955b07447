#pragma once

#include <cstddef>

namespace parmesan {

/// The index into a container that a number of a vertex, triangle or segment is; it must not be negative.
constexpr std::size_t at(int number) { return static_cast<std::size_t>(number); }

}  // namespace parmesan
