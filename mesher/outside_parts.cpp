#include "mesher/outside_parts.h"

#include <algorithm>
#include <vector>

#include "mesher/geometry/isolated_points.h"
#include "mesher/geometry/point_finder.h"
#include "mesher/index.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

std::vector<std::string> missing_segments(const Mesh& mesh, const Domain& domain) {
  std::vector<bool> is_there(domain.segments.size(), false);
  for (const int s : mesh.labels) is_there[at(s)] = true;
  std::vector<std::string> missing;
  for (std::size_t s = 0; s < is_there.size(); ++s) {
    const Segment& segment = domain.segments[s];
    if (!is_there[s])
      missing.push_back("the segment from " + text(domain.points[at(segment.a)]) + " to " +
                        text(domain.points[at(segment.b)]));
  }
  return missing;
}

std::vector<std::string> missing_points(const Mesh& mesh, const Domain& domain) {
  const std::vector<int> isolated = isolated_points(domain);
  if (isolated.empty()) return {};
  const PointFinder vertices(mesh.points);
  std::vector<std::string> missing;
  for (const int p : isolated)
    if (!vertices.holds(domain.points[at(p)])) missing.push_back("the point " + text(domain.points[at(p)]));
  return missing;
}

}  // namespace

std::optional<std::string> outside_parts(const Mesh& mesh, const Domain& domain) {
  constexpr std::size_t most_named = 5;
  std::vector<std::string> missing = missing_segments(mesh, domain);
  std::ranges::move(missing_points(mesh, domain), std::back_inserter(missing));
  if (missing.empty()) return std::nullopt;
  std::string sentence = "left out what lies outside of the domain: ";
  for (std::size_t i = 0; i < std::min(missing.size(), most_named); ++i) sentence += (i > 0 ? ", " : "") + missing[i];
  if (missing.size() > most_named) sentence += ", and " + text(static_cast<int>(missing.size() - most_named)) + " more";
  return sentence;
}

}  // namespace parmesan
