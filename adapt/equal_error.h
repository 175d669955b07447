#pragma once

#include <span>

namespace parmesan {

/// Where a family of meshes reaches a given error.
struct EqualError {
  enum class Found {
    Interpolated,   // between two meshes of the family
    BelowSmallest,  // already the smallest mesh is better; size is its own
    NotReached      // not even the largest mesh; size is its own
  };
  Found found = Found::NotReached;
  double size = 0.0;
};

/// The size at which the error of a family falls to the given one, on straight lines through
/// (log size, log error) of meshes of ascending size. Size: vertices, or what else a mesh costs.
///
/// Shape: sizes and errors of equal length, at least 1. Never extrapolates.
EqualError size_for_error(std::span<const double> sizes, std::span<const double> errors, double error);

}  // namespace parmesan
