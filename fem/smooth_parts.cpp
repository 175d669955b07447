#include "fem/smooth_parts.h"

#include <algorithm>
#include <cmath>

#include "fem/boundary_conditions.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

bool differ(const Diffusion& a, const Diffusion& b) {
  constexpr double tolerance = 0.01;
  const auto largest = [](const Diffusion& k) { return std::max({std::abs(k.xx), std::abs(k.xy), std::abs(k.yy)}); };
  const Diffusion jump = a - b;
  return !(largest(jump) <= tolerance * std::min(largest(a), largest(b)));  // NaN too
}

/// The sides along which the mesh comes apart. One between two tips cannot.
std::vector<char> opening_sides(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                                const GoalFunctional* dual_of) {
  std::vector<char> opens(sides.size(), 0);
  std::vector<char> degree(mesh.points.size(), 0);  // of sides that open and those of the outline, 2 for many
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const bool is_weighed = dual_of != nullptr && sides[s].interior && dual_of->sides.contains(sides[s].label);
    opens[s] = is_weighed || gradient_jumps(mesh, problem, sides[s]) ? 1 : 0;
    if (!opens[s] && sides[s].interior) continue;
    for (const int v : {sides[s].from, sides[s].to}) {
      char& d = degree[at(v)];
      if (d < 2) ++d;
    }
  }
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const bool is_alone = degree[at(sides[s].from)] < 2 && degree[at(sides[s].to)] < 2;
    if (is_alone) opens[s] = 0;
  }
  return opens;
}

}  // namespace

bool gradient_jumps(const Mesh& mesh, const Problem& problem, const Side& side) {
  if (!side.interior) return false;
  if (condition_on(problem, side)) return true;
  if (!problem.diffusion || side.region == side.other_region) return false;
  const Point middle = midpoint(mesh.points[at(side.from)], mesh.points[at(side.to)]);
  return differ(problem.diffusion(middle, side.region), problem.diffusion(middle, side.other_region));
}

SmoothParts::SmoothParts(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                         const GoalFunctional* dual_of)
    : whole_(&mesh) {
  const std::vector<char> opens = opening_sides(mesh, problem, sides, dual_of);
  if (std::ranges::count(opens, 0) == std::ssize(opens)) return;
  std::vector<std::optional<int>> right_labels(sides.size());
  for (std::size_t s = 0; s < sides.size(); ++s)
    if (opens[s]) right_labels[s] = sides[s].label;
  opened_ = open_cracks(mesh, right_labels);
}

std::vector<double> SmoothParts::spread(std::span<const double> values) const {
  return opened_ ? opened_->spread(values) : std::vector<double>(values.begin(), values.end());
}

}  // namespace parmesan
