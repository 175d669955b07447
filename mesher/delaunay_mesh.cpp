#include "mesher/delaunay_mesh.h"

#include <optional>
#include <string>
#include <utility>

#include "mesher/geometry/clean.h"
#include "mesher/geometry/outline.h"
#include "mesher/outside_parts.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "mesher/user_labels.h"

namespace parmesan {

DelaunayMesh delaunay_mesh(const Domain& domain) {
  CleanDomain cleaned = clean(domain);
  const Outline outline = outline_of(cleaned.domain);
  DelaunayMesh result;
  Mesh mesh = to_mesh(triangulate(outline.domain), outline.segments).mesh;
  result.repairs = std::move(cleaned.repairs);
  if (std::optional<std::string> outside = outside_parts(mesh, cleaned.domain))
    result.repairs.push_back(std::move(*outside));
  result.mesh = with_user_labels(std::move(mesh), cleaned.domain).mesh;
  return result;
}

}  // namespace parmesan
