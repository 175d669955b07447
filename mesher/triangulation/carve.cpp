#include "mesher/triangulation/carve.h"

#include <span>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "mesher/number_text.h"
#include "mesher/triangulation/flood.h"
#include "mesher/triangulation/locate.h"

namespace parmesan {
namespace {

// While carving, faces carry how many constraints part them from infinity; unknown at first. Before
// regions are painted all inside faces carry inside_face.
constexpr std::int32_t unknown = -1;
constexpr std::int32_t inside_face = outside_face + 1;  // below min_region

/// Numbers faces by the constraints between them and infinity: 0 is outside.
void number_layers(Triangulation& t) {
  std::vector<EdgeId> next = flood_from_hull(t, unknown);
  for (std::int32_t layer = 1; !next.empty(); ++layer) next = flood(t, std::move(next), unknown, layer);
}

void mark_inside(Triangulation& t, Inside rule) {
  for_each_side(t, [&](EdgeId e) {
    const std::int32_t layer = t.left(e);
    const bool inside = rule == Inside::EvenOdd ? layer % 2 == 1 : layer > 0;
    t.set_left(e, inside ? inside_face : 0);
  });
}

/// A triangle around the seed; kind and index are for the message.
EdgeId face_of_seed(const Triangulation& t, const Point& seed, const std::string& kind, std::size_t index) {
  const auto fail = [&](const std::string& problem) {
    throw GeometryError(kind + " seed " + std::to_string(index) + " at " + text(seed) + " " + problem,
                        {static_cast<int>(index)});
  };
  const Location where = locate(t, seed, some_inside_edge(t));
  if (where.hit == Hit::Outside) fail("lies outside of the domain");
  if (where.hit == Hit::Edge && t.is_constrained(where.edge)) fail("lies on a segment");
  if (where.hit == Hit::Vertex) {
    for_each_spoke(t, t.org(where.edge), [&](EdgeId e) {
      if (t.is_constrained(e)) fail("lies on an end of a segment");
    });
  }
  EdgeId e = where.edge;
  while (!t.is_inside_left(e)) e = t.onext(e);
  if (t.left(e) == 0) fail("lies outside of the domain");
  return e;
}

// Seeds are all located before the first flood, for two of them may lie in one hole.
void cut_holes(Triangulation& t, std::span<const Point> holes) {
  std::vector<EdgeId> faces;
  for (std::size_t i = 0; i < holes.size(); ++i) faces.push_back(face_of_seed(t, holes[i], "hole", i));
  flood(t, std::move(faces), inside_face, 0);
}

std::vector<EdgeId> find_regions(const Triangulation& t, std::span<const RegionSeed> seeds) {
  std::vector<EdgeId> faces;
  for (std::size_t i = 0; i < seeds.size(); ++i) faces.push_back(face_of_seed(t, seeds[i].point, "region", i));
  return faces;
}

void paint_regions(Triangulation& t, std::span<const RegionSeed> seeds, std::span<const EdgeId> faces) {
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    flood(t, {faces[i]}, inside_face, seeds[i].region);
    if (t.left(faces[i]) != seeds[i].region)
      throw GeometryError("region seed " + std::to_string(i) + " at " + text(seeds[i].point) +
                              " lies in an area that has another region already",
                          {static_cast<int>(i)});
  }
  for_each_side(t, [&](EdgeId e) {
    if (t.left(e) == inside_face) t.set_left(e, 0);
  });
}

/// A vertex in which just one constraint ends; no_vertex if there is none.
VertexId open_end(const Triangulation& t) {
  for (VertexId v = 0; v < t.num_slots(); ++v) {
    if (!t.has_vertex(v) || t.edge_of(v) == no_edge) continue;
    int count = 0;
    for_each_spoke(t, v, [&](EdgeId e) { count += t.is_constrained(e) ? 1 : 0; });
    if (count == 1) return v;
  }
  return no_vertex;
}

void require_inside(const Triangulation& t) {
  bool any = false;
  for_each_side(t, [&](EdgeId e) { any = any || t.left(e) == inside_face; });
  if (any) return;
  const VertexId v = open_end(t);
  if (v == no_vertex) throw GeometryError("the domain is empty: no area is enclosed by segments and not a hole");
  throw GeometryError("the boundary is not closed: it ends at point " + std::to_string(v) + " " + text(t.point(v)),
                      {v});
}

void remove_outside(Triangulation& t) {
  for_each_side(t, [&](EdgeId e) {
    if (t.left(e) == 0) t.set_left(e, outside_face);
  });
  for (std::int32_t q = 0; q < t.size(); ++q) {
    const EdgeId e{4 * q};
    if (t.is_alive(q) && !t.is_inside_left(e) && !t.is_inside_right(e)) t.remove_edge(e);
  }
  for (VertexId v = 0; v < t.num_slots(); ++v)
    if (t.has_vertex(v) && t.edge_of(v) == no_edge) t.remove_isolated_vertex(v);
}

}  // namespace

void carve(Triangulation& t, const Domain& domain) {
  number_layers(t);
  mark_inside(t, domain.inside);
  require_inside(t);
  cut_holes(t, domain.holes);
  require_inside(t);
  const std::vector<EdgeId> regions = find_regions(t, domain.regions);
  remove_outside(t);
  paint_regions(t, domain.regions, regions);
}

}  // namespace parmesan
