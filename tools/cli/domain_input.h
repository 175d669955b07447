#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// Adds --repair to a subcommand that reads a geometry. repair must outlive it.
void add_repair_option(CLI::App& command, bool& repair);

/// Reads a geometry; with repair its crossing segments are split, with a warning that names them.
/// Errors: as read_any_geometry, and with repair as clean.
Domain read_domain(const std::string& path, bool repair);

}  // namespace parmesan
