#include "mesher/particles/population.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "mesher/metric/metric_length.h"
#include "mesher/parallel.h"
#include "mesher/particles/circumcentre.h"
#include "mesher/particles/collapse.h"
#include "mesher/particles/edge_measures.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/sampled_sum.h"
#include "mesher/particles/selection.h"
#include "mesher/particles/thesis_rules.h"
#include "mesher/particles/triangle_share.h"
#include "mesher/triangulation/delaunay.h"

namespace parmesan {
namespace {

double squared_edge_length(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  return squared_length_in_mean(displacement(particles, e), particles.metric(mesh.org(e)),
                                particles.metric(mesh.dest(e)));
}

// The mean share of the two triangles of a free edge.
double mean_share(const ParticleSystem& particles, EdgeId e) {
  return 0.5 * (share_left(particles, e) + share_left(particles, sym(e)));
}

// Of the triangles on both sides of a free edge.
bool have_too_much_area(const ParticleSystem& particles, EdgeId e, const PopulationRules& rules) {
  const double area = (left_area(particles, e) + left_area(particles, sym(e))) / (1.0 + rules.area_slack);
  const auto is_too_much = [&](double of_area) { return gain_of_creation(of_area, rules.virtual_triangles) > 0.0; };
  return is_too_much(area) || is_too_much(area / mean_share(particles, e));
}

bool is_too_long(const ParticleSystem& particles, EdgeId e, const PopulationRules& rules) {
  if (particles.mesh().is_constrained(e)) return false;
  return squared_edge_length(particles, e) > rules.long_edge * rules.long_edge &&
         have_too_much_area(particles, e, rules);
}

// The four triangles that a particle in the middle of e would make.
double quality_of_halves(const ParticleSystem& particles, EdgeId e, const Point& p) {
  const Triangulation& mesh = particles.mesh();
  double smallest = std::numeric_limits<double>::infinity();
  for (const EdgeId side : {e, sym(e)}) {
    const Point& a = mesh.point(mesh.org(side));
    const Point& b = mesh.point(mesh.dest(side));
    const Point& c = mesh.point(mesh.left_apex(side));
    const Metric m = mean_metric_left(particles, side);
    smallest = std::min({smallest, mean_ratio(a, p, c, m), mean_ratio(p, b, c, m)});
  }
  return smallest;
}

bool is_resolved_at(const ParticleSystem& particles, EdgeId e) {
  const Triangulation& mesh = particles.mesh();
  return is_resolved_at(particles, mesh.org(e)) && is_resolved_at(particles, mesh.dest(e));
}

struct LongEdge {
  double squared_length;
  EdgeId edge;
  VertexId org;
  VertexId dest;
};

std::vector<LongEdge> long_edges(const ParticleSystem& particles, const PopulationRules& rules) {
  const Triangulation& mesh = particles.mesh();
  const auto size = static_cast<std::size_t>(mesh.size());
  auto found = collect<LongEdge>(size, [&](std::size_t first, std::size_t last, std::vector<LongEdge>& of_range) {
    for (auto q = static_cast<std::int32_t>(first); q < static_cast<std::int32_t>(last); ++q) {
      const EdgeId e{4 * q};
      if (!mesh.is_alive(q) || !is_too_long(particles, e, rules)) continue;
      if (rules.only_resolved && !is_resolved_at(particles, e)) continue;
      of_range.push_back({squared_edge_length(particles, e), e, mesh.org(e), mesh.dest(e)});
    }
  });
  std::sort(found.begin(), found.end(), [](const LongEdge& a, const LongEdge& b) {
    return a.squared_length != b.squared_length ? a.squared_length > b.squared_length : a.edge.index < b.edge.index;
  });
  return found;
}

VertexId create_particle(ParticleSystem& particles, EdgeId e, CreationPlace place) {
  constexpr double min_quality = 0.01;
  const Triangulation& mesh = particles.mesh();
  if (place == CreationPlace::Circumcentre) {
    const VertexId v = create_at_circumcentre(particles, e, min_quality);
    if (v != no_vertex) return v;
  }
  const Point p = midpoint(mesh.point(mesh.org(e)), mesh.point(mesh.dest(e)));
  const double quality = quality_of_halves(particles, e, p);
  return quality >= min_quality || quality >= min_quality * mean_share(particles, e) ? particles.create_on_edge(e, p)
                                                                                     : no_vertex;
}

}  // namespace

int create_particles(ParticleSystem& particles, const PopulationRules& rules, std::int64_t max_vertices) {
  Triangulation& mesh = particles.mesh();
  std::vector<EdgeId> stack;
  int created = 0;
  for (const LongEdge& found : long_edges(particles, rules)) {
    if (created == rules.most) break;
    const EdgeId e = found.edge;
    const bool unchanged = mesh.org(e) == found.org && mesh.dest(e) == found.dest;
    if (!unchanged || !is_too_long(particles, e, rules)) continue;
    if (mesh.num_vertices() >= max_vertices)
      throw LimitError("the metric asks for more than " + std::to_string(max_vertices) + " vertices");
    const VertexId v = create_particle(particles, e, rules.creation);
    if (v == no_vertex) continue;
    add_link(mesh, v, stack);
    legalize(particles, stack, flips_after_change);
    ++created;
  }
  return created;
}

namespace {

// The triangles of the star by their shares.
double num_triangles(const ParticleSystem& particles, const Star& star) {
  double sum = 0.0;
  for (std::size_t i = 0; i < star.size(); ++i) sum += share_left(particles, star.spoke(i).edge);
  return sum;
}

bool has_too_little_area(const ParticleSystem& particles, const Star& star, VertexId v, const PopulationRules& rules) {
  const double area = star.metric_area(particles.mesh().point(v), particles.metric(v)) / (1.0 - rules.area_slack);
  return is_superfluous_inside(area, static_cast<double>(star.size())) &&
         is_superfluous_inside(area, num_triangles(particles, star));
}

bool is_superfluous(const ParticleSystem& particles, const Star& star, VertexId v, const PopulationRules& rules) {
  const double short_edge = rules.short_edge;
  const Point& p = particles.mesh().point(v);
  const Metric& m = particles.metric(v);
  if (has_too_little_area(particles, star, v, rules)) return true;
  for (std::size_t i = 0; i < star.size(); ++i)
    if (squared_length_in_mean(star.spoke(i).point - p, m, star.spoke(i).metric) < short_edge * short_edge) return true;
  return false;
}

// The spokes of v, the shortest first.
std::vector<LongEdge> spokes_by_length(const ParticleSystem& particles, VertexId v) {
  std::vector<LongEdge> spokes;
  for_each_spoke(particles.mesh(), v, [&](EdgeId e) {
    spokes.push_back({squared_edge_length(particles, e), e, v, particles.mesh().dest(e)});
  });
  std::sort(spokes.begin(), spokes.end(), [](const LongEdge& a, const LongEdge& b) {
    return a.squared_length != b.squared_length ? a.squared_length < b.squared_length : a.edge.index < b.edge.index;
  });
  return spokes;
}

// Adds the edges that changed: those of the hole that v leaves, or of the neighbour it merges into; none when it stays.
void annihilate_particle(ParticleSystem& particles, const Star& star, VertexId v, Annihilation how,
                         std::vector<EdgeId>& changed) {
  constexpr std::size_t max_tries = 3;
  Triangulation& mesh = particles.mesh();
  if (how == Annihilation::Removal) {
    changed = remove_star(mesh, v);
    return;
  }
  const std::vector<LongEdge> spokes = spokes_by_length(particles, v);
  for (std::size_t i = 0; i < std::min(max_tries, spokes.size()); ++i) {
    if (!can_collapse(particles, star, v, spokes[i].edge)) continue;
    mesh.collapse(spokes[i].edge);
    for_each_spoke(mesh, spokes[i].dest, [&](EdgeId e) { changed.push_back(e); });
    return;
  }
}

bool is_limited(const PopulationRules& rules) { return rules.most < std::numeric_limits<int>::max(); }

// Of a star over that of the rule, but for a factor.
double relative_area(const ParticleSystem& particles, const Star& star, VertexId v) {
  const double n = num_triangles(particles, star);
  return star.metric_area(particles.mesh().point(v), particles.metric(v)) / std::sqrt(n * std::max(0.0, n - 2.0));
}

struct Superfluous {
  double area = 0.0;
  VertexId particle = no_vertex;
};

// In the order of their numbers, or the smallest stars first where only some may go.
std::vector<Superfluous> superfluous_particles(const ParticleSystem& particles, const PopulationRules& rules) {
  const auto selects = [&](const Star& star, VertexId v) {
    return is_superfluous(particles, star, v, rules) &&
           (!rules.only_resolved || star.is_resolved(particles.mesh().point(v), particles.metric(v)));
  };
  std::vector<Superfluous> found;
  for (const VertexId v : select_free_particles(particles, selects)) found.push_back({.particle = v});
  if (!is_limited(rules)) return found;
  Star star;
  for (Superfluous& one : found) {
    star.gather(particles, one.particle);
    one.area = relative_area(particles, star, one.particle);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Superfluous& a, const Superfluous& b) { return a.area < b.area; });
  return found;
}

}  // namespace

int annihilate_particles(ParticleSystem& particles, const PopulationRules& rules) {
  Star star;
  std::vector<EdgeId> changed;
  int annihilated = 0;
  for (const Superfluous& found : superfluous_particles(particles, rules)) {
    if (annihilated == rules.most) break;
    const VertexId v = found.particle;
    star.gather(particles, v);
    if (!is_superfluous(particles, star, v, rules)) continue;  // since a neighbour went
    if (is_limited(rules) && relative_area(particles, star, v) > found.area) continue;
    annihilate_particle(particles, star, v, rules.annihilation, changed);
    if (changed.empty()) continue;
    legalize(particles, changed, flips_after_change);
    ++annihilated;
  }
  return annihilated;
}

namespace {

constexpr std::int32_t enough_for_shares = 20000;

double demand_of_star(const ParticleSystem& particles, VertexId v, const PopulationRules& rules) {
  if (!particles.mesh().has_vertex(v) || !particles.is_free(v)) return 0.0;
  Star star;
  star.gather(particles, v);
  if (!is_superfluous(particles, star, v, rules)) return 0.0;
  return star.is_resolved(particles.mesh().point(v), particles.metric(v)) ? 1.0 : 0.0;
}

double demand_of_edge(const ParticleSystem& particles, std::int32_t q, const PopulationRules& rules) {
  const Triangulation& mesh = particles.mesh();
  const EdgeId e{4 * q};
  if (!mesh.is_alive(q) || !is_too_long(particles, e, rules)) return 0.0;
  if (is_too_long(particles, e, outlier_rules)) return squared_edge_length(particles, e);
  return is_resolved_at(particles, e) ? 1.0 : 0.0;
}

}  // namespace

double population_demand(const ParticleSystem& particles, const PopulationRules& rules) {
  const Triangulation& mesh = particles.mesh();
  const double of_stars = sampled_sum(mesh.num_slots(), enough_for_shares,
                                      [&](std::int32_t v) { return demand_of_star(particles, v, rules); });
  const double of_edges =
      sampled_sum(mesh.size(), enough_for_shares, [&](std::int32_t q) { return demand_of_edge(particles, q, rules); });
  return (of_stars + of_edges) / mesh.num_vertices();
}

}  // namespace parmesan
