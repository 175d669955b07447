#include "mesher/delaunay_mesh.h"

#include <utility>

#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"

namespace parmesan {

DelaunayMesh delaunay_mesh(const Domain& domain) {
  CleanDomain cleaned = clean(domain);
  std::vector<int> labels;
  labels.reserve(cleaned.domain.segments.size());
  for (const Segment& segment : cleaned.domain.segments) labels.push_back(segment.label);
  DelaunayMesh result;
  result.mesh = to_mesh(triangulate(cleaned.domain), labels).mesh;
  result.mesh.label_names = domain.label_names;
  result.mesh.region_names = domain.region_names;
  result.repairs = std::move(cleaned.repairs);
  return result;
}

}  // namespace parmesan
