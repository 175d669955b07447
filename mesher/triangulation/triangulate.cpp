#include "mesher/triangulation/triangulate.h"

#include <numeric>
#include <utility>
#include <vector>

#include "mesher/index.h"
#include "mesher/triangulation/carve.h"
#include "mesher/triangulation/constraints.h"
#include "mesher/triangulation/delaunay.h"

namespace parmesan {

Triangulation triangulate(const Domain& domain) {
  PointTriangulation sites = delaunay(domain.points);
  std::vector<int> vertex_of(domain.points.size());
  std::iota(vertex_of.begin(), vertex_of.end(), 0);
  for (const DuplicatePoint& d : sites.duplicates) vertex_of[at(d.point)] = d.first;
  std::vector<Segment> segments = domain.segments;
  for (Segment& s : segments) {
    s.a = vertex_of[at(s.a)];
    s.b = vertex_of[at(s.b)];
  }
  insert_constraints(sites.triangulation, segments);
  carve(sites.triangulation, domain);
  return std::move(sites.triangulation);
}

}  // namespace parmesan
