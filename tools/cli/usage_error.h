#pragma once

#include <CLI/CLI.hpp>

#include "tools/cli/exit_code.h"

namespace parmesan {

/// Looks at the values of the chosen subcommand that no file can have for its name. Errors: CLI::ValidationError for an
/// empty one, as a shell makes of a variable that is not set, and for an output "-", which would be a file of this
/// name.
void check_names(const CLI::App& program);

/// Prints what is wrong with the command line, and the nearest name where an option or a subcommand is unknown.
ExitCode report_usage_error(const CLI::App& program, const CLI::ParseError& error);

}  // namespace parmesan
