#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace parmesan {

/// Which of thesis 3.3's potentials acts between particles.
enum class PotentialKind {
  Gaussian,                   // before 3.16, repulsive only
  GaussianDerivative,         // 3.16
  LennardJones,               // 3.18
  Shimada,                    // 3.19
  LennardJonesApproximation,  // 3.20
  Laplacian,                  // 3.21, attractive only
  LengthError,                // 3.22
  RatioError                  // 3.24
};

/// Which particles act on one: those at one edge (3.14), at two edges or less (3.15), or nearer than a radius.
enum class Neighbourhood { N1, N2, Radius };

/// How a potential becomes a force in a metric: its gradient 5.15, or along the edge 5.16.
enum class Force { Gradient, AlongEdge };

/// How the length of an edge is computed from the metrics of its ends.
enum class EdgeDistance {
  LinearMetric,  // 5.6
  MeanLength,    // 5.7
  MeanMetric     // 5.8
};

/// How a free particle goes to its new place: it is removed and inserted there (3.1.3), or moved as far as the star
/// allows.
enum class Relocation { Reinsert, InPlace };

/// Where a particle is created on an edge that is split, or in the larger of its triangles.
enum class CreationPlace { EdgeMidpoint, Circumcentre };

/// How a free particle goes: its star is triangulated again, or it merges into the nearest neighbour that allows it.
enum class Annihilation { Removal, Collapse };

/// How the next particle is picked among those alive: at random, or one after the other along a Hilbert curve.
enum class Picking { Uniform, BySpeed, Hilbert };

/// What F. Bossen's thesis (CMU-CS-96-134) leaves to the user: how particles act on each other, and how they come and
/// go. By default 3.20 over N1 with 5.16 and 5.8, midpoints, and the rest as the schedule has it; that of the thesis as
/// it was written: first order, removal, remove and reinsert. The fast schedule does not read the last four.
struct ParticleOptions {
  PotentialKind potential = PotentialKind::LennardJonesApproximation;
  double decay = 1.0;  // d of 3.20, positive
  Neighbourhood neighbourhood = Neighbourhood::N1;
  double radius = 1.5;  // c of 3.2, in unit edges, for Neighbourhood::Radius
  Force force = Force::AlongEdge;
  EdgeDistance distance = EdgeDistance::MeanMetric;
  // delta of 3.12, by default (1 - momentum) of Newton's step on the hexagonal lattice, and beta of 3.13, in [0, 1),
  // 0 is first order. Without either the fast schedule has its own.
  std::optional<double> step = {};
  std::optional<double> momentum = {};
  bool virtual_triangles = true;  // in the creation rule of 3.4.2
  CreationPlace creation = CreationPlace::EdgeMidpoint;
  std::optional<Annihilation> annihilation = {};  // none: the schedule's
  double alive_speed = 0.01;                      // those slower die: metric length of delta v, in one pick
  Relocation relocation = Relocation::Reinsert;
  Picking picking = Picking::Uniform;
  double max_picks = 400.0;  // per particle; who is alive then is said in the report
};

/// Are the forces between particles those that the fast schedule has in a fast form: 3.20 with d = 1, N1, 5.16, 5.8 and
/// its own step and momentum?
bool has_default_forces(const ParticleOptions& options);

/// Names in case files and on the command line.
template <class T>
using OptionName = std::pair<std::string_view, T>;

inline constexpr std::array<OptionName<PotentialKind>, 8> potential_names{
    {{"gaussian", PotentialKind::Gaussian},
     {"gaussian-derivative", PotentialKind::GaussianDerivative},
     {"lennard-jones", PotentialKind::LennardJones},
     {"shimada", PotentialKind::Shimada},
     {"lennard-jones-approximation", PotentialKind::LennardJonesApproximation},
     {"laplacian", PotentialKind::Laplacian},
     {"length-error", PotentialKind::LengthError},
     {"ratio-error", PotentialKind::RatioError}}};
inline constexpr std::array<OptionName<Neighbourhood>, 3> neighbourhood_names{
    {{"n1", Neighbourhood::N1}, {"n2", Neighbourhood::N2}, {"radius", Neighbourhood::Radius}}};
inline constexpr std::array<OptionName<Force>, 2> force_names{
    {{"gradient", Force::Gradient}, {"along-edge", Force::AlongEdge}}};
inline constexpr std::array<OptionName<EdgeDistance>, 3> distance_names{{{"linear-metric", EdgeDistance::LinearMetric},
                                                                         {"mean-length", EdgeDistance::MeanLength},
                                                                         {"mean-metric", EdgeDistance::MeanMetric}}};
inline constexpr std::array<OptionName<Relocation>, 2> relocation_names{
    {{"reinsert", Relocation::Reinsert}, {"in-place", Relocation::InPlace}}};
inline constexpr std::array<OptionName<CreationPlace>, 2> creation_names{
    {{"midpoint", CreationPlace::EdgeMidpoint}, {"circumcentre", CreationPlace::Circumcentre}}};
inline constexpr std::array<OptionName<Annihilation>, 2> annihilation_names{
    {{"removal", Annihilation::Removal}, {"collapse", Annihilation::Collapse}}};
inline constexpr std::array<OptionName<Picking>, 3> picking_names{
    {{"uniform", Picking::Uniform}, {"by-speed", Picking::BySpeed}, {"hilbert", Picking::Hilbert}}};

/// What the name stands for; the names must have it.
template <class T, std::size_t N>
constexpr T named_value(const std::array<OptionName<T>, N>& names, std::string_view name) {
  for (const auto& [known, value] : names)
    if (known == name) return value;
  return names[0].second;
}

/// Throws InputError unless every number is in its range.
void validate(const ParticleOptions& options);

}  // namespace parmesan
