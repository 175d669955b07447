#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "adapt/io/any_geometry.h"
#include "mesher/geometry/domain.h"

namespace parmesan {

/// Adds --repair to a subcommand that reads a geometry. repair must outlive it.
void add_repair_option(CLI::App& command, bool& repair);

/// Reads a geometry, that of a case file too; with repair its crossing segments are split, with a warning that names
/// them. Errors: as read_any_geometry and read_case_domain, and with repair as clean.
Domain read_domain(const std::string& path, bool repair);

/// The same with the mesh that the geometry is given by, if it is. regions: names of those whose triangles are to be
/// required, too. Errors: also GeometryError where the geometry has no such region, or is no mesh.
GeometryInput read_geometry_to_mesh(const std::string& path, bool repair, const std::vector<std::string>& regions);

}  // namespace parmesan
