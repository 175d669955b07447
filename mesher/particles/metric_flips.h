#pragma once

#include <vector>

#include "mesher/particles/territory.h"

namespace parmesan {

/// The in-circle test 5.13 for the edge from a to b with the apexes c (left) and d (right) in the
/// metric m: is d inside of the ellipse through a, b and c? With a margin against cycles.
bool fails_in_circle(const Point& a, const Point& b, const Point& c, const Point& d, const SymmetricTensor& m);

/// Would both triangles be counter-clockwise, by exact orientation, if e were flipped? e must be free.
bool can_flip(const Triangulation& mesh, EdgeId e);

/// Should e give way to the other diagonal: the in-circle test 5.13 in the mean metric of the four
/// vertices, with a margin against cycles. True only if e is free, both new triangles are
/// counter-clockwise by exact orientation, and no sliver (quality under 0.05) becomes worse.
bool wants_flip(const ParticleSystem& particles, EdgeId e);

/// Adds the edges that legalize is to look at where v came, moved or took in another particle: its spokes, and the
/// sides opposite to it.
void add_star(const Triangulation& mesh, VertexId v, std::vector<EdgeId>& stack);

/// Adds the sides opposite to v, for legalize where v came.
void add_link(const Triangulation& mesh, VertexId v, std::vector<EdgeId>& stack);

/// The cap for legalize after one change.
inline constexpr long flips_after_change = 100;

/// Flips the edges on the stack, and those that come to want it, until none does or the number
/// of flips reaches the cap. Edges whose quadrilateral leaves the territory stay. Empties the stack.
/// Returns the number of flips.
long legalize(ParticleSystem& particles, std::vector<EdgeId>& stack, long cap, const Territory& territory = {});

/// Legalizes every edge. Cost: O(n), on all threads. Returns the number of flips.
long flip_all(ParticleSystem& particles);

}  // namespace parmesan
