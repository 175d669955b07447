#include "tools/bench/cgal_delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <utility>
#include <vector>

namespace parmesan::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

std::vector<Kernel::Point_2> cgal_points(const Domain& domain) {
  std::vector<Kernel::Point_2> points;
  for (const Point& p : domain.points) points.emplace_back(p.x, p.y);
  return points;
}

std::vector<std::pair<std::size_t, std::size_t>> index_pairs(const Domain& domain) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const Segment& s : domain.segments) pairs.emplace_back(s.a, s.b);
  return pairs;
}

constexpr auto count_vertices = [](const auto& triangulation) { return triangulation.number_of_vertices(); };

}  // namespace

std::optional<Timing> cgal_delaunay(const Domain& domain) {
  const auto points = cgal_points(domain);
  return time([&] { return CGAL::Delaunay_triangulation_2<Kernel>(points.begin(), points.end()); }, count_vertices);
}

std::optional<Timing> cgal_constrained(const Domain& domain) {
  const auto points = cgal_points(domain);
  const auto segments = index_pairs(domain);
  return time(
      [&] {
        CGAL::Constrained_Delaunay_triangulation_2<Kernel> result;
        result.insert_constraints(points.begin(), points.end(), segments.begin(), segments.end());
        return result;
      },
      count_vertices);
}

}  // namespace parmesan::bench
