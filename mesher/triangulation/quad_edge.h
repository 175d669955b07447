#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace parmesan {

/// Index of a vertex in the point array of a triangulation.
using VertexId = std::int32_t;
inline constexpr VertexId no_vertex = -1;

/// A directed edge, after Guibas & Stolfi, ACM Trans. Graphics 4(2), 1985.
///
/// The four directed edges of undirected edge q are numbered 4q + r:
/// r = 0 primal, 1 its dual, 2 the primal reversed, 3 the dual reversed.
/// An EdgeId stays valid until its edge is deleted.
struct EdgeId {
  std::int32_t index = -1;
  constexpr bool operator==(const EdgeId&) const = default;
};
inline constexpr EdgeId no_edge{};

/// The dual edge, from the right face of e to its left face ("Rot").
constexpr EdgeId rot(EdgeId e) { return {(e.index & ~3) | ((e.index + 1) & 3)}; }

/// The dual edge from the left face of e to its right face ("Rot^-1").
constexpr EdgeId inv_rot(EdgeId e) { return {(e.index & ~3) | ((e.index + 3) & 3)}; }

/// The same edge in the opposite direction ("Sym").
constexpr EdgeId sym(EdgeId e) { return {e.index ^ 2}; }

/// Index of the undirected edge of e.
constexpr std::int32_t undirected(EdgeId e) { return e.index >> 2; }

/// Connectivity of a planar subdivision and its dual. Knows no coordinates.
///
///            dest(e)
///       dnext|   |lnext         ring of org(e), counter-clockwise:
///            |e  |              ... oprev(e), e, onext(e) ...
///   right    |   |  left        face rings: lnext to the left of e,
///       oprev|   |onext         rnext to its right
///            org(e)
class QuadEdge {
 public:
  void reserve(std::size_t num_edges) { rings_.reserve(4 * num_edges); }

  /// Number of slots, freed ones included: undirected edges are 0 .. size() - 1.
  std::int32_t size() const { return static_cast<std::int32_t>(rings_.size() / 4); }
  bool is_alive(std::int32_t q) const { return rings_[4 * static_cast<std::size_t>(q)].next != no_edge; }

  /// Adds an isolated edge e; afterwards onext(e) == e and both end points are unset.
  /// Slots of deleted edges are used again, the last freed first.
  EdgeId make_edge();

  /// Appends n edges whose end points and links are unset, to be linked by hand. Returns the first of them; the
  /// others follow in steps of 4.
  EdgeId append_edges(std::size_t n) {
    const EdgeId first{4 * size()};
    rings_.resize(rings_.size() + 4 * n);
    return first;
  }

  /// Joins or parts the edge rings of the origins of a and b, and those of
  /// their left faces. Its own inverse. Cost: O(1).
  void splice(EdgeId a, EdgeId b);

  /// Puts the isolated edge e between two places: its origin into the ring of a, before onext(a),
  /// its destination into that of b (thesis 2.2.3).
  void connect(EdgeId e, EdgeId a, EdgeId b);

  /// Takes e out of both its rings; e stays as an isolated edge (thesis 2.2.4).
  void disconnect(EdgeId e);

  /// Replaces e by the other diagonal of its quadrilateral; e turns counter-clockwise. Both faces
  /// of e must be triangles. Applied twice it gives sym(e).
  void swap(EdgeId e);

  /// Frees an isolated edge (thesis 2.2.6).
  void delete_edge(EdgeId e);

  EdgeId onext(EdgeId e) const { return rings_[slot(e)].next; }
  EdgeId oprev(EdgeId e) const { return rot(onext(rot(e))); }
  EdgeId lnext(EdgeId e) const { return rot(onext(inv_rot(e))); }
  EdgeId lprev(EdgeId e) const { return sym(onext(e)); }
  EdgeId rnext(EdgeId e) const { return inv_rot(onext(rot(e))); }
  EdgeId rprev(EdgeId e) const { return onext(sym(e)); }
  EdgeId dnext(EdgeId e) const { return sym(onext(sym(e))); }
  EdgeId dprev(EdgeId e) const { return inv_rot(onext(inv_rot(e))); }

  VertexId org(EdgeId e) const { return rings_[slot(e)].org; }
  VertexId dest(EdgeId e) const { return org(sym(e)); }
  void set_org(EdgeId e, VertexId v) { rings_[slot(e)].org = v; }
  void set_dest(EdgeId e, VertexId v) { set_org(sym(e), v); }

  /// What the faces carry (the origins of the dual edges); meaning is the owner's.
  std::int32_t left(EdgeId e) const { return rings_[slot(inv_rot(e))].org; }
  std::int32_t right(EdgeId e) const { return rings_[slot(rot(e))].org; }
  void set_left(EdgeId e, std::int32_t face) { rings_[slot(inv_rot(e))].org = face; }
  void set_right(EdgeId e, std::int32_t face) { rings_[slot(rot(e))].org = face; }

  /// Links a ring by hand: afterwards onext(a) == b and oprev(b) == a. For building many triangles
  /// at once: a subdivision is whole when every edge has been linked to its successor.
  void link(EdgeId a, EdgeId b) {
    rings_[slot(a)].next = b;
    rings_[slot(rot(b))].next = inv_rot(a);
  }

 private:
  static std::size_t slot(EdgeId e) {
    assert(e.index >= 0);
    return static_cast<std::size_t>(e.index);
  }

  /// What each directed edge knows. The four of one edge fill half a cache line.
  struct Place {
    EdgeId next = no_edge;     // onext; no_edge when freed
    VertexId org = no_vertex;  // on dual edges what their face carries
  };

  std::vector<Place> rings_;         // 4 per edge
  std::vector<std::int32_t> freed_;  // undirected edges to use again
};

}  // namespace parmesan
