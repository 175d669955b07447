#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "tools/cli/exit_code.h"

namespace parmesan {

/// A subcommand: how its arguments are read, and what it does once they are.
struct Command {
  CLI::App* app = nullptr;
  std::function<ExitCode()> run;
};

/// Each adds one subcommand to the program. The options it reads live as long as its Command.
Command add_run_command(CLI::App& program);
Command add_compare_command(CLI::App& program);
Command add_mesh_command(CLI::App& program);
Command add_quality_command(CLI::App& program);
Command add_convert_command(CLI::App& program);
Command add_check_command(CLI::App& program);
Command add_schema_command(CLI::App& program);
Command add_report_command(CLI::App& program);

}  // namespace parmesan
