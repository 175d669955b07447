#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesher/diagnosis.h"
#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"
#include "mesher/metric/metric_field.h"
#include "mesher/metric/tensor_field.h"
#include "mesher/start_choice.h"

namespace parmesan {

/// How much relaxation a mesh is given.
enum class Preset { Fast, Mid, Good };

/// How generate works. Every field has a default that suits most meshes.
struct GenerateOptions {
  Preset preset = Preset::Good;
  std::uint64_t seed = 1;                  // of the random engine, where a schedule uses one
  std::int64_t max_vertices = 10'000'000;  // safety limit, LimitError beyond

  // Signed second derivatives of a function, U / L^2, not owned. When given, the finished mesh is changed so that the
  // L2 error of the function's interpolant falls, and stays a unit mesh: see ErrorDescent.
  const TensorField* hessian = nullptr;
};

/// What happened inside generate.
struct GenerateReport {
  Start start = Start::Scratch;
  std::string start_reason;  // why that and not another
  double complexity = 0.0;   // integral of sqrt(det M) over the mesh
  Diagnosis diagnosis;       // where the mesh misses its metric, and why
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
/// the domain and choose_start finds it near enough to the metric. Otherwise the mesh is the one made
/// without it. Same input, same bits. The mesh returned has passed validate().
///
/// Errors: GeometryError for a domain that clean() refuses; LimitError when the integral of the
/// metric asks for more than max_vertices; MeshingError when no valid mesh could be made.
/// Cost: O(n).
GenerateResult generate(const Domain& domain, const MetricField& field, const GenerateOptions& options = {},
                        const Mesh* previous = nullptr);

}  // namespace parmesan
