#include "fem/load.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/coefficients.h"
#include "fem/p1.h"
#include "mesher/index.h"
#include "mesher/parallel.h"

namespace parmesan {

namespace {

constexpr double orbit_factor = 50.0;  // a difference of the two orbits of this many tolerances calls for subdivision
constexpr int max_depth = 10;
constexpr std::size_t max_parts = 100'000;       // of one level; a source that is noise asks for any number
constexpr std::size_t max_rough_parts = 25'000;  // the same where the roughest are chosen

/// A part of a triangle and what was sampled there.
struct SampledPart {
  std::size_t triangle = 0;
  TrianglePart part;
  SourceSample sample;
};

/// Four children of a part with their sums.
struct Children {
  std::array<SampledPart, 4> parts;
  SourceMoments moments{};
  double magnitude = 0.0;

  /// The children agree with their parent.
  bool confirm(const SourceSample& parent, double local, double global) const {
    double change = 0.0;
    for (std::size_t i = 0; i < 3; ++i) change = std::max(change, std::abs(moments[i] - parent.moments[i]));
    return change <= std::max(global, local * magnitude);
  }
};

/// How closely each triangle is looked at.
struct LoadTolerance {
  double local = 0.0;       // of a part's own integral of |f|
  double global = 0.0;      // of the mean integral of |f| over a triangle
  double negligible = 0.0;  // what all triangles together may lose by jumps that their points do not see
  int min_depth = 0;

  bool sees_corners() const { return min_depth > 0; }
};

LoadTolerance tolerance_for(const std::vector<SourceSample>& samples, const LoadAccuracy& accuracy) {
  double magnitude = 0.0;
  for (const SourceSample& sample : samples) magnitude += sample.magnitude;
  const auto n = static_cast<double>(samples.size());
  const double global = accuracy.tolerance * magnitude / n;
  return {accuracy.tolerance, global, 0.1 * global * n, accuracy.min_depth};
}

/// The corners of a part see a jump that its points do not, and what that can cost is not negligible.
bool hides_jump(const SourceSample& sample, double negligible) {
  return sample.corner_spread > std::max(3.0 * sample.spread, negligible);
}

Children children_of(const Mesh& mesh, const Problem& problem, const SampledPart& parent, bool with_corners) {
  const std::size_t t = parent.triangle;
  const P1Element element = p1_element(mesh, static_cast<int>(t));
  const ElementSource source(problem, element, mesh.regions[t], with_corners);
  Children children;
  const std::array<TrianglePart, 4> parts = subdivide(parent.part);
  for (std::size_t k = 0; k < 4; ++k) {
    children.parts[k] = {t, parts[k], source.sample(parts[k])};
    children.magnitude += children.parts[k].sample.magnitude;
    for (std::size_t i = 0; i < 3; ++i) children.moments[i] += children.parts[k].sample.moments[i];
  }
  return children;
}

void add(const SourceMoments& part, SourceMoments& sum) {
  for (std::size_t i = 0; i < 3; ++i) sum[i] += part[i];
}

/// Leaves open as many parts, those whose points differ most; the others are what was sampled there.
void keep_roughest(std::size_t number, std::vector<SampledPart>& open, std::vector<SourceMoments>& result) {
  std::ranges::stable_sort(open, std::ranges::greater{}, [](const SampledPart& part) {
    return std::max(part.sample.spread, part.sample.corner_spread);
  });
  for (std::size_t k = number; k < open.size(); ++k) add(open[k].sample.moments, result[open[k].triangle]);
  open.resize(number);
}

/// Subdivides until children confirm their parents: to the local tolerance of their own magnitude, or to the global
/// one, which halves with each level because a layer meets twice as many parts. result: the moments of the triangles
/// that are not open; returned with all.
std::vector<SourceMoments> refine(const Mesh& mesh, const Problem& problem, std::vector<SampledPart> open,
                                  const LoadTolerance& tolerance, std::vector<SourceMoments> result) {
  const bool chooses = tolerance.sees_corners();
  const std::size_t most = ((chooses ? max_rough_parts : max_parts) + result.size()) / 4;  // of parents
  for (int depth = 1; depth <= max_depth && !open.empty(); ++depth) {
    if (open.size() > most) {
      if (!chooses) break;
      keep_roughest(most, open, result);
    }
    const std::vector<SampledPart> parents = std::exchange(open, {});
    std::vector<Children> families(parents.size());
    for_each_in_parallel(parents.size(), [&](std::size_t k) {
      families[k] = children_of(mesh, problem, parents[k], tolerance.sees_corners());
    });
    for (std::size_t k = 0; k < parents.size(); ++k) {
      const SampledPart& parent = parents[k];
      const Children& children = families[k];
      const bool is_confirmed =
          children.confirm(parent.sample, tolerance.local, std::ldexp(tolerance.global, 1 - depth));
      if (is_confirmed && depth > tolerance.min_depth && !hides_jump(parent.sample, tolerance.negligible)) {
        add(children.moments, result[parent.triangle]);
      } else {
        open.insert(open.end(), children.parts.begin(), children.parts.end());
      }
    }
  }
  for (const SampledPart& part : open) add(part.sample.moments, result[part.triangle]);
  return result;
}

/// The orbits differ; for functions that jump also: the points do, or the corners differ from all of them.
bool is_rough(const SourceSample& sample, const LoadTolerance& tolerance) {
  if (sample.orbit_error > std::max(tolerance.global, orbit_factor * tolerance.local * sample.magnitude)) return true;
  if (!tolerance.sees_corners()) return false;
  return sample.spread > std::max(tolerance.global, 0.5 * sample.magnitude) || hides_jump(sample, tolerance.negligible);
}

/// 1 for the triangles whose orbits differ and for those that share an edge (or a vertex) with one: where a layer
/// crosses triangles that do not resolve it, the orbits of a few agree by chance.
std::vector<char> near_rough_triangles(const Mesh& mesh, const std::vector<SourceSample>& samples,
                                       const LoadTolerance& tolerance) {
  const std::ptrdiff_t shared = tolerance.sees_corners() ? 1 : 2;
  std::vector<char> rough_vertex(static_cast<std::size_t>(mesh.num_vertices()), 0);
  for (std::size_t t = 0; t < samples.size(); ++t) {
    if (!is_rough(samples[t], tolerance)) continue;
    for (const int v : mesh.triangles[t]) rough_vertex[at(v)] = 1;
  }
  std::vector<char> result(samples.size());
  for (std::size_t t = 0; t < samples.size(); ++t) {
    const std::array<int, 3>& v = mesh.triangles[t];
    const auto touches = [&](int i) { return rough_vertex[at(i)] != 0; };
    result[t] = std::count_if(v.begin(), v.end(), touches) >= shared ? 1 : 0;
  }
  return result;
}

}  // namespace

std::vector<SourceMoments> source_moments(const Mesh& mesh, const Problem& problem, const LoadAccuracy& accuracy) {
  if (!problem.source && !uses_divergence_form(problem)) return {};
  std::vector<SourceSample> samples(mesh.triangles.size());
  for_each_in_parallel(samples.size(), [&](std::size_t t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    samples[t] = ElementSource(problem, element, mesh.regions[t], accuracy.min_depth > 0).sample({});
  });
  const LoadTolerance tolerance = tolerance_for(samples, accuracy);
  const std::vector<char> suspected = near_rough_triangles(mesh, samples, tolerance);
  std::vector<SourceMoments> result(samples.size());
  std::vector<SampledPart> open;
  for (std::size_t t = 0; t < samples.size(); ++t) {
    if (suspected[t]) {
      open.push_back({t, {}, samples[t]});
    } else {
      result[t] = samples[t].moments;
    }
  }
  return refine(mesh, problem, std::move(open), tolerance, std::move(result));
}

}  // namespace parmesan
