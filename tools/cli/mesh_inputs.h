#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "mesher/geometry/domain.h"
#include "mesher/metric/background_mesh.h"
#include "mesher/metric/metric_field.h"
#include "mesher/metric/tensor_interpolant.h"

namespace parmesan {

/// What a mesh is to be like, and where it starts: numbers and files of the command line.
struct MeshInputOptions {
  std::optional<double> size, align;
  std::string background, metric, indicator, from, hessian;
  std::int64_t vertices = 0;  // that indicators are to be turned into
  double order = 2.0;         // of the error that indicators tell of
  MetricInterpolation interpolation = MetricInterpolation::LogEuclidean;
};

/// Adds --size, --background, --metric, --indicator, --from and what goes with them to a subcommand.
void add_mesh_input_options(CLI::App& app, MeshInputOptions& options);

/// The metric asked for, the same turned along boundaries, the Hessian of a function whose error is to be lowered, and
/// the mesh to start from.
struct MeshInputs {
  std::unique_ptr<MetricField> field, aligned;
  std::unique_ptr<TensorField> hessian;
  std::optional<Mesh> previous;

  const MetricField& metric() const { return aligned ? *aligned : *field; }
};

/// Reads them, with warnings of what does not fit. Without a size or a background sizes follow from the domain.
/// geometry: its file, for messages. Errors: as the readers; GeometryError with the file's name.
MeshInputs read_mesh_inputs(const MeshInputOptions& options, const Domain& domain, const std::string& geometry);

}  // namespace parmesan
