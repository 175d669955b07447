#include "mesher/delaunay_mesh.h"

#include <utility>

#include "mesher/geometry/outline.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "mesher/user_labels.h"

namespace parmesan {

DelaunayMesh delaunay_mesh(const Domain& domain) {
  CleanDomain cleaned = clean(domain);
  const Outline outline = outline_of(cleaned.domain);
  DelaunayMesh result;
  result.mesh = with_user_labels(to_mesh(triangulate(outline.domain), outline.segments).mesh, cleaned.domain).mesh;
  result.repairs = std::move(cleaned.repairs);
  return result;
}

}  // namespace parmesan
