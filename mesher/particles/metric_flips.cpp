#include "mesher/particles/metric_flips.h"

#include <algorithm>

#include "mesher/geometry/predicates.h"
#include "mesher/index.h"
#include "mesher/metric/metric_length.h"
#include "mesher/parallel.h"
#include "mesher/particles/blocks.h"

namespace parmesan {
namespace {

// Would flipping the edge from a to b, with c on its left and d on its right, make no sliver worse?
bool spares_slivers(const Point& a, const Point& b, const Point& c, const Point& d, const Metric& m) {
  constexpr double sliver = 0.05;
  const double after = std::min(mean_ratio(d, c, a, m), mean_ratio(c, d, b, m));
  if (after >= sliver) return true;
  return after > std::min(mean_ratio(a, b, c, m), mean_ratio(b, a, d, m));
}

}  // namespace

bool fails_in_circle(const Point& a, const Point& b, const Point& c, const Point& d, const SymmetricTensor& m) {
  constexpr double margin = 1e-10;
  const double sin_a = cross(d - a, c - a);
  const double cos_a = dot(d - a, m * (c - a));
  const double sin_b = cross(c - b, d - b);
  const double cos_b = dot(c - b, m * (d - b));
  return sin_a * cos_b + cos_a * sin_b > margin * (std::abs(sin_a * cos_b) + std::abs(cos_a * sin_b));
}

bool can_flip(const Triangulation& mesh, EdgeId e) {
  const Point& c = mesh.point(mesh.left_apex(e));
  const Point& d = mesh.point(mesh.right_apex(e));
  return orient2d(d, c, mesh.point(mesh.org(e))) > 0.0 && orient2d(c, d, mesh.point(mesh.dest(e))) > 0.0;
}

bool wants_flip(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  if (mesh.is_constrained(e)) return false;  // a free edge has triangles on both sides
  const VertexId va = mesh.org(e);
  const VertexId vb = mesh.dest(e);
  const VertexId vc = mesh.left_apex(e);
  const VertexId vd = mesh.right_apex(e);
  const Point& a = mesh.point(va);
  const Point& b = mesh.point(vb);
  const Point& c = mesh.point(vc);
  const Point& d = mesh.point(vd);
  const Metric m =
      mean(mean(particles.metric(va), particles.metric(vb)), mean(particles.metric(vc), particles.metric(vd)));
  return fails_in_circle(a, b, c, d, m.tensor()) && can_flip(mesh, e) && spares_slivers(a, b, c, d, m);
}

namespace {

bool contains_quadrilateral(const Territory& territory, const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  const auto contains = [&](VertexId v) { return territory.contains(particles, v); };
  return contains(mesh.org(e)) && contains(mesh.dest(e)) && contains(mesh.left_apex(e)) && contains(mesh.right_apex(e));
}

}  // namespace

void add_star(const Triangulation& mesh, VertexId v, std::vector<EdgeId>& stack) {
  for_each_spoke(mesh, v, [&](EdgeId e) { stack.insert(stack.end(), {e, mesh.lnext(e)}); });
}

void add_link(const Triangulation& mesh, VertexId v, std::vector<EdgeId>& stack) {
  for_each_spoke(mesh, v, [&](EdgeId e) { stack.push_back(mesh.lnext(e)); });
}

long legalize(ParticleSystem& particles, std::vector<EdgeId>& stack, long cap, const Territory& territory) {
  Triangulation& mesh = particles.mesh();
  long flips = 0;
  while (!stack.empty()) {
    const EdgeId e = stack.back();
    stack.pop_back();
    if (flips >= cap || !mesh.is_alive(undirected(e))) continue;
    if (!contains_quadrilateral(territory, particles, e) || !wants_flip(particles, e)) continue;
    mesh.flip(e);
    ++flips;
    for (const EdgeId side : {mesh.onext(e), mesh.oprev(e), mesh.onext(sym(e)), mesh.oprev(sym(e))})
      stack.push_back(side);
  }
  return flips;
}

namespace {

constexpr long flips_per_edge = 3;

/// What flipping in a block has left to do.
struct Remainder {
  std::vector<EdgeId> edges;  // whose quadrilaterals leave the block
  long flips = 0;
};

// An edge is met at the end that its even number belongs to.
Remainder flip_block(ParticleSystem& particles, const Block& block) {
  Remainder remainder;
  std::vector<EdgeId> edges;
  std::vector<EdgeId> stack;
  for (const VertexId v : block.particles) {
    edges.clear();
    for_each_spoke(particles.mesh(), v, [&](EdgeId e) {
      if ((e.index & 2) == 0) edges.push_back(e);
    });
    for (const EdgeId e : edges) {
      if (!contains_quadrilateral(block.territory, particles, e)) {
        remainder.edges.push_back(e);
        continue;
      }
      stack.push_back(e);
      const long cap = flips_per_edge * 3 * static_cast<long>(block.particles.size());
      remainder.flips += legalize(particles, stack, cap - remainder.flips, block.territory);
    }
  }
  return remainder;
}

}  // namespace

long flip_all(ParticleSystem& particles) {
  const Blocks order(particles);
  const std::vector<Block> blocks = order.cut(0);
  std::vector<Remainder> remainders(blocks.size());
  parallel_for(static_cast<int>(blocks.size()),
               [&](int i) { remainders[at(i)] = flip_block(particles, blocks[at(i)]); });
  long flips = 0;
  long cap = flips_per_edge * particles.mesh().size();
  for (Remainder& r : remainders) {
    const long after = legalize(particles, r.edges, cap);
    flips += r.flips + after;
    cap -= after;
  }
  return flips;
}

}  // namespace parmesan
