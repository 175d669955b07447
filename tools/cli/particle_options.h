#pragma once

#include <CLI/CLI.hpp>

#include "mesher/generate.h"

namespace parmesan {

/// Adds --schedule and the parameters of the thesis's schedule to a subcommand. options must outlive it.
void add_schedule_options(CLI::App& command, GenerateOptions& options);

}  // namespace parmesan
