#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/errors.h"
#include "tools/cli/commands.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/large_arrays.h"
#include "tools/cli/usage_error.h"
#include "tools/cli/version.h"

namespace {

constexpr const char* footer =
    "Results go to standard output, the log and errors to standard error.\n"
    "Exit codes: 0 done, 1 bug, 2 usage, 3 case invalid, 4 geometry invalid, 5 no valid mesh, 6 solve failed,\n"
    "7 file problem, 8 safety limit, 9 target missed, 130 (143, 129) interrupted.\n"
    "Help on one subcommand: parmesan SUBCOMMAND --help";

// A file that is opened while one of 0, 1, 2 is closed gets its number, and what is printed goes into that file. Of
// /dev/null opened for reading one can write nothing, so that flush_results sees that the output is lost.
void open_standard_streams() {
  int descriptor = 0;
  do descriptor = open("/dev/null", O_RDONLY);
  while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) close(descriptor);
}

[[noreturn]] void end_without_memory() {
  constexpr std::string_view message = "parmesan: error: not enough memory; see --limit memory_mb\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
  _exit(static_cast<int>(parmesan::ExitCode::LimitHit));
}

bool has_ended = false;

// Libraries for which there is no memory or no thread, as OpenMP's, end the program by exit(1).
void end_for_library() {
  if (!has_ended) end_without_memory();
}

// Where a destructor needs memory and there is none, as for a JSON value, no handler is reached.
[[noreturn]] void end_without_unwinding() {
  try {
    if (const std::exception_ptr current = std::current_exception()) std::rethrow_exception(current);
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (...) {
  }
  std::abort();
}

// A pipe that was closed or a full disk shows when the last bytes are written.
parmesan::ExitCode flush_results(parmesan::ExitCode code) {
  if (std::cout.flush()) return code;
  throw parmesan::FileError("standard output", 0, "cannot be written");
}

parmesan::ExitCode run_program(int argc, char** argv) {
  CLI::App program("Parmesan: anisotropic particle meshes and adaptive finite elements in the plane.", "parmesan");
  program.footer(footer);
  program.require_subcommand(1);
  program.set_version_flag("--version", parmesan::version_text, "Print version, compiler and features");
  const std::vector<parmesan::Command> commands{
      parmesan::add_run_command(program),    parmesan::add_compare_command(program),
      parmesan::add_mesh_command(program),   parmesan::add_quality_command(program),
      parmesan::add_check_command(program),  parmesan::add_convert_command(program),
      parmesan::add_schema_command(program), parmesan::add_report_command(program)};
  try {
    program.parse(argc, argv);
    parmesan::check_names(program);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return parmesan::report_usage_error(program, error);
    program.exit(error);  // help or version
    return flush_results(parmesan::ExitCode::Done);
  }
  const auto is_chosen = [](const parmesan::Command& command) { return command.app->parsed(); };
  return flush_results(std::find_if(commands.begin(), commands.end(), is_chosen)->run());
}

}  // namespace

int main(int argc, char** argv) {
  signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a file problem like a full disk
  std::set_terminate(end_without_unwinding);
  open_standard_streams();
  give_back_large_arrays();
  std::atexit(end_for_library);
  parmesan::ExitCode code{};
  try {
    code = run_program(argc, argv);
  } catch (...) {
    code = parmesan::report_current_exception();
  }
  has_ended = true;
  return static_cast<int>(code);
}
