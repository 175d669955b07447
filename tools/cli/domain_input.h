#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "adapt/io/any_geometry.h"
#include "mesher/geometry/domain.h"

namespace parmesan {

/// What is to be mended in a geometry instead of refusing or keeping it.
struct RepairOptions {
  bool split_crossings = false;
  double merge_tolerance = 0.0;  // as Domain::merge_tolerance; 0: what the geometry itself asks for
};

/// Adds --repair and --merge-tolerance to a subcommand that reads a geometry. options must outlive it.
void add_repair_options(CLI::App& command, RepairOptions& options);

/// Whether it is a mesh with triangles that are required to stay.
bool keeps_triangles(const GeometryInput& geometry);

/// Reads a geometry, that of a case file too, and mends it, with a warning that names what was changed.
/// Errors: as read_geometry_input and read_case_geometry, and as clean where something is to be mended.
Domain read_domain(const std::string& path, const RepairOptions& options);

/// The same with the mesh that the geometry is given by, if it is. regions: names of those whose triangles are to be
/// required, too. Errors: also GeometryError where the geometry has no such region, or is no mesh.
GeometryInput read_geometry_to_mesh(const std::string& path, const RepairOptions& options,
                                    const std::vector<std::string>& regions);

}  // namespace parmesan
