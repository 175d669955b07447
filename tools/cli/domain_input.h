#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// Adds --repair to a subcommand that reads a geometry. repair must outlive it.
void add_repair_option(CLI::App& command, bool& repair);

/// Reads a geometry, that of a case file too; with repair its crossing segments are split, with a warning that names
/// them. Errors: as read_any_geometry and read_case_domain, and with repair as clean.
Domain read_domain(const std::string& path, bool repair);

}  // namespace parmesan
