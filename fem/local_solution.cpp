#include "fem/local_solution.h"

#include <algorithm>
#include <map>
#include <utility>

#include "fem/p1.h"
#include "fem/point_sources.h"
#include "fem/singular_vertices.h"
#include "fem/vector_of.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// What the P1 function with these values is at a place of a mesh.
double value_at(const Mesh& mesh, const TrianglePlace& place, std::span<const double> values) {
  return p1_value(place.lambda, at_corners(mesh, at(place.triangle), values));
}

/// The values at those vertices of fine that are vertices of coarse.
std::vector<double> at_coarse(const RefinedPatch& patch, std::span<const double> fine) {
  std::vector<double> result(patch.vertices.size());
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const auto& [triangle, lambda] = patch.places[i];
    const auto corner = std::ranges::find(lambda, 1.0);
    if (corner == lambda.end()) continue;
    result[at(patch.coarse.triangles[at(triangle)][static_cast<std::size_t>(corner - lambda.begin())])] = fine[i];
  }
  return result;
}

/// The problem with that part of the point sources that the triangles of the patch have: they are shared by all that
/// hold the place.
Problem with_sources_of_patch(const Mesh& mesh, const RefinedPatch& patch, Problem problem) {
  const std::vector<std::vector<TrianglePlace>> places = places_of_sources(mesh, problem);
  std::vector<PointSource> sources;
  for (std::size_t k = 0; k < places.size(); ++k) {
    PointSource source = problem.point_sources[k];
    const std::vector<TrianglePlace>& holders = places[k];
    const auto inside = std::ranges::count_if(
        holders, [&](const TrianglePlace& p) { return std::ranges::binary_search(patch.triangles, p.triangle); });
    source.strength *= static_cast<double>(inside) / static_cast<double>(holders.size());
    if (inside > 0) sources.push_back(source);
  }
  problem.point_sources = std::move(sources);
  return problem;
}

}  // namespace

LocalSolution::LocalSolution(const SmoothParts& parts, const Problem& problem, const std::vector<Side>& sides)
    : mesh_(parts.whole()) {
  try {
    patch_ = refined_patch(mesh_, sides, singular_vertices(parts, problem, sides));
    if (!patch_.triangles.empty()) prepare(with_sources_of_patch(mesh_, patch_, problem));
  } catch (const InputError&) {  // of data at points that the solution did not look at, which stands all the same
    equations_.reset();
  } catch (const SolveError&) {
    equations_.reset();
  }
}

void LocalSolution::prepare(const Problem& problem) {
  const std::vector<Side> fine_sides = labelled_sides(patch_.fine);
  coarse_ = assemble_with_conditions(patch_.coarse, problem, labelled_sides(patch_.coarse));
  fine_ = assemble_with_conditions(patch_.fine, problem, fine_sides);
  dirichlet_ = dirichlet_values(patch_.fine, problem, fine_sides);
  std::vector<char> fixed = dirichlet_.fixed;
  for (std::size_t i = 0; i < fixed.size(); ++i)
    if (patch_.is_cut[i]) fixed[i] = 1;
  const FixedVertices all{fixed, std::vector<double>(fixed.size(), 0.0)};
  if (!find_null_space(patch_.fine, fine_, all).components.empty()) return;
  equations_.emplace(fine_, std::move(fixed), nothing_);
}

std::vector<double> LocalSolution::given_values(std::span<const double> values,
                                                std::span<const Surplus> surplus) const {
  std::vector<double> given = dirichlet_.values;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!patch_.is_cut[i]) continue;  // where data of several sides meet, w has those of the whole mesh
    const TrianglePlace place{patch_.triangles[at(patch_.places[i].triangle)], patch_.places[i].lambda};
    given[i] = value_at(mesh_, place, values) + Quadratic{surplus[at(place.triangle)]}.at(place.lambda);
  }
  return given;
}

std::vector<Surplus> LocalSolution::surplus_of(std::span<const double> fine) const {
  const std::vector<double> corner = at_coarse(patch_, fine);
  std::map<std::array<int, 2>, double> of_side;
  const auto side = [this](std::size_t triangle, std::size_t opposite) {
    const auto& corners = patch_.coarse.triangles[triangle];
    const auto [a, b] = std::minmax(corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]);
    return std::array{a, b};
  };
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const auto& [triangle, lambda] = patch_.places[i];
    if (std::ranges::count(lambda, 0.5) != 2) continue;
    const std::array<int, 2> ends =
        side(at(triangle), static_cast<std::size_t>(std::ranges::find(lambda, 0.0) - lambda.begin()));
    of_side[ends] = fine[i] - 0.5 * (corner[at(ends[0])] + corner[at(ends[1])]);
  }
  std::vector<Surplus> result(patch_.triangles.size());
  for (std::size_t t = 0; t < result.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) result[t][k] = of_side.at(side(t, k));
  return result;
}

std::optional<LocalCorrection> LocalSolution::correct(std::span<const double> values,
                                                      std::span<const Surplus> surplus) {
  std::vector<double> fine;
  try {
    fine = equations_->solve(fine_.load, given_values(values, surplus)).values;
  } catch (const SolveError&) {
    return std::nullopt;
  }
  std::vector<double> w(patch_.vertices.size());
  for (std::size_t v = 0; v < w.size(); ++v) w[v] = values[at(patch_.vertices[v])];
  LocalCorrection result{.change = at_coarse(patch_, fine), .surplus = surplus_of(fine), .load = {}};
  result.load = coarse_.matrix * vector_of(w) - coarse_.load;
  const Eigen::VectorXd residual = fine_.matrix * vector_of(fine) - fine_.load;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const auto& [triangle, lambda] = patch_.places[i];
    for (std::size_t k = 0; k < 3; ++k)
      result.load[patch_.coarse.triangles[at(triangle)][k]] -= lambda[k] * residual[static_cast<Eigen::Index>(i)];
  }
  for (std::size_t v = 0; v < w.size(); ++v) result.change[v] -= w[v];
  return result;
}

}  // namespace parmesan
