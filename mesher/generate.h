#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesher/diagnosis.h"
#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"
#include "mesher/metric/metric_field.h"
#include "mesher/metric/tensor_field.h"
#include "mesher/particles/mesh_observer.h"
#include "mesher/particles/particle_options.h"
#include "mesher/particles/thesis_schedule.h"
#include "mesher/start_choice.h"

namespace parmesan {

/// How much relaxation a mesh is given.
enum class Preset { Fast, Mid, Good };

/// How particles are brought to equilibrium: sweep by sweep, or as the thesis does it, pick by pick.
enum class Schedule { Fast, Thesis };

inline constexpr std::array<OptionName<Preset>, 3> preset_names{
    {{"fast", Preset::Fast}, {"mid", Preset::Mid}, {"good", Preset::Good}}};
inline constexpr std::array<OptionName<Schedule>, 2> schedule_names{
    {{"fast", Schedule::Fast}, {"thesis", Schedule::Thesis}}};

/// How generate works. Every field has a default that suits most meshes.
struct GenerateOptions {
  Schedule schedule = Schedule::Fast;
  Preset preset = Preset::Good;            // of the fast schedule
  ParticleOptions particles = {};          // forces and population
  std::uint64_t seed = 1;                  // of the random engine, where a schedule uses one
  std::int64_t max_vertices = 10'000'000;  // safety limit, LimitError beyond; never above 2^29 / 3
  double chord_error = 0.01;               // how far edges may be from a curve, as a share of its extent, above 0

  // Signed second derivatives of a function, U / L^2, not owned. When given, the finished mesh is changed so that the
  // L2 error of the function's interpolant falls, and stays a unit mesh: see ErrorDescent.
  const TensorField* hessian = nullptr;

  MeshObserver observer = {};  // called while the mesh is made
};

/// What happened inside generate.
struct GenerateReport {
  Start start = Start::Scratch;
  std::string start_reason;  // why that and not another
  double complexity = 0.0;   // integral of sqrt(det M) over the mesh
  Diagnosis diagnosis;       // where the mesh misses its metric, and why
  std::optional<ThesisReport> thesis;
  std::vector<std::string> warnings;
};

struct GenerateResult {
  Mesh mesh;
  std::vector<Metric> metrics;  // the field at each vertex
  std::optional<Mesh> relaxed;  // with options.hessian: as forces left it, the better start for the next mesh
  GenerateReport report;
};

/// Meshes the domain so that every edge has metric length close to 1.
///
/// previous: an earlier mesh of the same domain; its particles are the start when it conforms to
/// the domain and choose_start finds it near enough to the metric; the thesis's schedule starts from any that conforms.
/// Otherwise the mesh is the one made without it. Same input, same bits. The mesh returned has passed validate().
///
/// Vertices on curved segments are on the curves.
///
/// Errors: GeometryError for a domain that clean() refuses; LimitError when the integral of the
/// metric asks for more than max_vertices, or the mesh has more, or than 178 956 970, since edges have 32-bit numbers;
/// MeshingError when no valid mesh could be made. Cost: O(n).
GenerateResult generate(const Domain& domain, const MetricField& field, const GenerateOptions& options = {},
                        std::optional<Mesh> previous = std::nullopt);

}  // namespace parmesan
