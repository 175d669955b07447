#include <numeric>

#include "mesher/diagnosis.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

std::string_view explanation(MisfitReason reason) {
  switch (reason) {
    case MisfitReason::Required:
      return "at edges or triangles that are required to stay";
    case MisfitReason::SharpCorner:
      return "between segments that meet at less than 30 degrees in the metric";
    case MisfitReason::ClosePoints:
      return "between points of the geometry nearer than a unit edge";
    case MisfitReason::MetricJump:
      return "where the metric changes more than 3-fold within a triangle (limit its gradation)";
    case MisfitReason::BetweenConstraints:
      return "between two segments or points of the geometry";
    case MisfitReason::OnSegment:
      return "on segments that could not be divided as asked";
    case MisfitReason::Unknown:
      return "for no evident reason";
  }
  return "";
}

std::int64_t total(const std::vector<Misfits>& misfits) {
  return std::accumulate(misfits.begin(), misfits.end(), std::int64_t{0},
                         [](std::int64_t sum, const Misfits& m) { return sum + m.count; });
}

// "3 edges are ...: 2 where the metric jumps, the worst 12.3 at (0.5, 0.25); 1 ..."
std::string sentence(const std::vector<Misfits>& misfits, std::string_view one, std::string_view many) {
  const std::int64_t count = total(misfits);
  std::string result = std::to_string(count).append(count == 1 ? one : many);
  const char* separator = ": ";
  for (const Misfits& m : misfits) {
    result += separator + std::to_string(m.count) + " " + std::string(explanation(m.reason)) + ", " +
              (m.count == 1 ? "" : "the worst ") + text(m.worst, 3) + " at " + rounded_text(m.place);
    separator = "; ";
  }
  return result;
}

bool any_beyond(const std::vector<Misfits>& misfits, double low, double high) {
  return !misfits.empty() && (misfits.front().worst < low || misfits.front().worst > high);
}

}  // namespace

std::string_view to_string(MisfitReason reason) {
  switch (reason) {
    case MisfitReason::Required:
      return "required";
    case MisfitReason::SharpCorner:
      return "sharp_corner";
    case MisfitReason::ClosePoints:
      return "close_points";
    case MisfitReason::MetricJump:
      return "metric_jump";
    case MisfitReason::BetweenConstraints:
      return "between_constraints";
    case MisfitReason::OnSegment:
      return "on_segment";
    case MisfitReason::Unknown:
      return "unknown";
  }
  return "";
}

bool satisfies_metric(const Diagnosis& diagnosis) {
  constexpr double edges_per_triangle = 1.5;
  constexpr double few = 0.02;
  if (!diagnosis.poor_triangles.empty()) return false;
  if (any_beyond(diagnosis.long_edges, 0.0, 2.0) || any_beyond(diagnosis.short_edges, 0.5, 1.0)) return false;
  const auto out_of_range = static_cast<double>(total(diagnosis.long_edges) + total(diagnosis.short_edges));
  return out_of_range <= 2.0 + few * edges_per_triangle * static_cast<double>(diagnosis.num_triangles);
}

std::vector<std::string> sentences(const Diagnosis& diagnosis) {
  std::vector<std::string> all;
  if (!diagnosis.long_edges.empty())
    all.push_back(sentence(diagnosis.long_edges, " edge is longer than sqrt2 in the metric",
                           " edges are longer than sqrt2 in the metric"));
  if (!diagnosis.short_edges.empty())
    all.push_back(sentence(diagnosis.short_edges, " edge is shorter than 1/sqrt2 in the metric",
                           " edges are shorter than 1/sqrt2 in the metric"));
  if (!diagnosis.poor_triangles.empty())
    all.push_back(sentence(diagnosis.poor_triangles, " triangle has a quality under 0.3 in the metric",
                           " triangles have a quality under 0.3 in the metric"));
  return all;
}

}  // namespace parmesan
