#include "mesher/delaunay_mesh.h"

#include <numeric>
#include <utility>
#include <vector>

#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "mesher/user_labels.h"

namespace parmesan {

DelaunayMesh delaunay_mesh(const Domain& domain) {
  CleanDomain cleaned = clean(domain);
  std::vector<int> numbers(cleaned.domain.segments.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  DelaunayMesh result;
  result.mesh = with_user_labels(to_mesh(triangulate(cleaned.domain), numbers).mesh, cleaned.domain).mesh;
  result.repairs = std::move(cleaned.repairs);
  return result;
}

}  // namespace parmesan
