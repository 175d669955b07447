#pragma once

#include <CLI/CLI.hpp>

#include "tools/cli/exit_code.h"

namespace parmesan {

/// Prints what is wrong with the command line, and the nearest name where an option or a subcommand is unknown.
ExitCode report_usage_error(const CLI::App& program, const CLI::ParseError& error);

}  // namespace parmesan
