#include "mesher/triangulation/quad_edge.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

namespace parmesan {
namespace {

/// An arbitrary subdivision: edges joined by random splices of primal edges.
QuadEdge random_subdivision(int num_edges, unsigned seed) {
  std::mt19937 engine(seed);
  QuadEdge q;
  for (int i = 0; i < num_edges; ++i) q.make_edge();
  const auto primal = [&] { return EdgeId{static_cast<std::int32_t>(engine() % (2U * unsigned(num_edges)) * 2U)}; };
  for (int i = 0; i < 3 * num_edges; ++i) {
    const EdgeId a = primal();
    q.splice(a, primal());
  }
  return q;
}

std::vector<EdgeId> links(const QuadEdge& q) {
  std::vector<EdgeId> all;
  for (std::int32_t i = 0; i < 4 * q.size(); ++i) all.push_back(q.onext({i}));
  return all;
}

/// The square 0 1 2 3, counter-clockwise, with the diagonal 0 -> 2 and its outside.
struct Square {
  QuadEdge q;
  EdgeId diagonal;
  std::vector<EdgeId> sides;
};

Square make_square() {
  Square s;
  for (VertexId v = 0; v < 4; ++v) {
    s.sides.push_back(s.q.make_edge());
    s.q.set_org(s.sides.back(), v);
    s.q.set_dest(s.sides.back(), (v + 1) % 4);
  }
  for (std::size_t i = 0; i < 4; ++i) s.q.splice(sym(s.sides[i]), s.sides[(i + 1) % 4]);
  s.diagonal = s.q.make_edge();
  s.q.connect(s.diagonal, s.sides[0], s.sides[2]);
  return s;
}

}  // namespace

TEST_CASE("rot and sym form the group of four directed edges", "[mesher][triangulation]") {
  const EdgeId e{4 * 7 + GENERATE(0, 1, 2, 3)};
  CHECK(rot(rot(e)) == sym(e));
  CHECK(sym(sym(e)) == e);
  CHECK(inv_rot(rot(e)) == e);
  CHECK(rot(inv_rot(e)) == e);
  CHECK(rot(rot(rot(e))) == inv_rot(e));
  CHECK(!(rot(e) == e));
  CHECK(!(sym(e) == e));
  CHECK(undirected(rot(e)) == 7);
}

TEST_CASE("a new edge is the subdivision of the sphere with two vertices and one face", "[mesher][triangulation]") {
  QuadEdge q;
  const EdgeId e = q.make_edge();
  CHECK(q.onext(e) == e);
  CHECK(q.onext(sym(e)) == sym(e));
  CHECK(q.lnext(e) == sym(e));
  CHECK(q.rnext(e) == sym(e));
  CHECK(q.onext(rot(e)) == inv_rot(e));
  CHECK(q.org(e) == no_vertex);
  CHECK(q.dest(e) == no_vertex);
}

TEST_CASE("edge algebra: the axioms of Guibas and Stolfi hold in any subdivision", "[mesher][triangulation]") {
  const QuadEdge q = random_subdivision(40, 7);
  std::vector<int> entered(4U * 40U, 0);
  for (std::int32_t i = 0; i < 4 * q.size(); ++i) {
    const EdgeId e{i};
    CHECK(rot(q.onext(rot(q.onext(e)))) == e);  // E2: e Rot Onext Rot Onext = e, read from the right
    ++entered[static_cast<std::size_t>(q.onext(e).index)];
    CHECK(((q.onext(e).index ^ e.index) & 1) == 0);  // E5: primal stays primal
  }
  CHECK(std::ranges::all_of(entered, [](int n) { return n == 1; }));
}

TEST_CASE("edge algebra: navigation obeys thesis 2.1 to 2.5", "[mesher][triangulation]") {
  const QuadEdge q = random_subdivision(40, 11);
  for (std::int32_t i = 0; i < 4 * q.size(); ++i) {
    const EdgeId e{i};
    // Inverse pairs.
    CHECK(q.oprev(q.onext(e)) == e);
    CHECK(q.lprev(q.lnext(e)) == e);
    CHECK(q.rprev(q.rnext(e)) == e);
    CHECK(q.dprev(q.dnext(e)) == e);
    // By duality a ring of vertices is a ring of faces.
    CHECK(q.lnext(e) == rot(q.onext(inv_rot(e))));
    CHECK(q.rnext(e) == inv_rot(q.onext(rot(e))));
    CHECK(q.dnext(e) == sym(q.onext(sym(e))));
    CHECK(q.oprev(e) == rot(q.onext(rot(e))));
    // By reversal.
    CHECK(q.lprev(e) == sym(q.onext(e)));
    CHECK(q.rprev(e) == q.onext(sym(e)));
    CHECK(q.dprev(e) == sym(q.oprev(sym(e))));
    CHECK(q.rnext(e) == sym(q.lnext(sym(e))));
  }
}

TEST_CASE("splice is its own inverse", "[mesher][triangulation]") {
  QuadEdge q = random_subdivision(30, 3);
  const std::vector<EdgeId> before = links(q);
  std::mt19937 engine(5);
  for (int k = 0; k < 200; ++k) {
    const EdgeId a{static_cast<std::int32_t>(engine() % 60U * 2U)};
    const EdgeId b{static_cast<std::int32_t>(engine() % 60U * 2U)};
    q.splice(a, b);
    q.splice(a, b);
    REQUIRE(links(q) == before);
  }
}

TEST_CASE("splice joins two rings and parts one", "[mesher][triangulation]") {
  QuadEdge q;
  const EdgeId a = q.make_edge();
  const EdgeId b = q.make_edge();
  q.splice(a, b);
  CHECK(q.onext(a) == b);
  CHECK(q.onext(b) == a);
  q.splice(a, b);
  CHECK(q.onext(a) == a);
  CHECK(q.onext(b) == b);
}

TEST_CASE("connect cuts a face in two and disconnect undoes it", "[mesher][triangulation]") {
  Square s = make_square();
  CHECK(s.q.org(s.diagonal) == 0);
  CHECK(s.q.dest(s.diagonal) == 2);
  CHECK(s.q.lnext(s.diagonal) == s.sides[2]);
  CHECK(s.q.lnext(s.q.lnext(s.diagonal)) == s.sides[3]);
  CHECK(s.q.lnext(sym(s.diagonal)) == s.sides[0]);
  s.q.disconnect(s.diagonal);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(s.q.lnext(s.sides[i]) == s.sides[(i + 1) % 4]);
    CHECK(s.q.org(s.sides[i]) == static_cast<VertexId>(i));
  }
  CHECK(s.q.onext(s.diagonal) == s.diagonal);
  CHECK(s.q.onext(sym(s.diagonal)) == sym(s.diagonal));
  CHECK(s.q.org(s.diagonal) == no_vertex);
  CHECK(s.q.dest(s.diagonal) == no_vertex);
}

TEST_CASE("swap turns the diagonal counter-clockwise to the other one", "[mesher][triangulation]") {
  Square s = make_square();
  s.q.swap(s.diagonal);
  CHECK(s.q.org(s.diagonal) == 1);
  CHECK(s.q.dest(s.diagonal) == 3);
  CHECK(s.q.lnext(s.diagonal) == s.sides[3]);
  CHECK(s.q.lnext(s.q.lnext(s.diagonal)) == s.sides[0]);
  CHECK(s.q.lnext(sym(s.diagonal)) == s.sides[1]);
  CHECK(s.q.lnext(s.q.lnext(sym(s.diagonal))) == s.sides[2]);
}

TEST_CASE("swap twice is sym, four times the identity", "[mesher][triangulation]") {
  Square s = make_square();
  const std::vector<EdgeId> before = links(s.q);
  const auto renamed = [&](EdgeId e) { return undirected(e) == undirected(s.diagonal) ? sym(e) : e; };
  s.q.swap(s.diagonal);
  s.q.swap(s.diagonal);
  CHECK(s.q.org(s.diagonal) == 2);
  CHECK(s.q.dest(s.diagonal) == 0);
  for (std::int32_t i = 0; i < 4 * s.q.size(); ++i)
    CHECK(s.q.onext(renamed({i})) == renamed(before[static_cast<std::size_t>(i)]));
  s.q.swap(s.diagonal);
  s.q.swap(s.diagonal);
  CHECK(links(s.q) == before);
}

TEST_CASE("deleted edges are used again, the last first", "[mesher][triangulation]") {
  QuadEdge q;
  const EdgeId a = q.make_edge();
  const EdgeId b = q.make_edge();
  q.delete_edge(a);
  q.delete_edge(b);
  CHECK(!q.is_alive(0));
  CHECK(!q.is_alive(1));
  CHECK(undirected(q.make_edge()) == 1);
  CHECK(undirected(q.make_edge()) == 0);
  CHECK(q.is_alive(0));
  CHECK(q.size() == 2);
}

TEST_CASE("faces carry values on both sides of an edge", "[mesher][triangulation]") {
  QuadEdge q;
  const EdgeId e = q.make_edge();
  q.set_left(e, 3);
  q.set_right(e, 4);
  CHECK(q.left(e) == 3);
  CHECK(q.right(e) == 4);
  CHECK(q.left(sym(e)) == 4);
  CHECK(q.org(rot(e)) == 4);  // rot(e) leads from the right face to the left one
  CHECK(q.dest(rot(e)) == 3);
}

}  // namespace parmesan
