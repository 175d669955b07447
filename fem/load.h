#pragma once

#include <array>
#include <vector>

#include "fem/problem.h"

namespace parmesan {

/// Integrals of f phi_0, f phi_1, f phi_2 over a triangle; with the divergence form, of r phi_i + q.grad phi_i.
using SourceMoments = std::array<double, 3>;

/// The moments of the source on each triangle; empty where the problem has no source.
///
/// Degree 4 first. A triangle on which the two point orbits of that rule differ, or that shares an edge
/// with one, is subdivided 1:4 until parent and children agree, at most 10 times, and as long as a level has at most
/// 100 000 parts and one per triangle more: steep sources are integrated well on coarse meshes.
/// Errors: ProblemError where the source is not finite.
std::vector<SourceMoments> source_moments(const Mesh& mesh, const Problem& problem);

}  // namespace parmesan
