#pragma once

#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace parmesan::support {

/// How the program ended and what it said.
struct ProgramResult {
  int exit_code = -1;  // 128 + number when a signal ended it
  std::string out;
  std::string err;
};

/// A signal to send to the program while it runs.
struct Interruption {
  int signal = 0;  // none
  int milliseconds = 0;
  std::string after = {};  // a file that the program writes first; the milliseconds count from then
};

/// Runs the built program with these arguments in a working folder and waits for it.
ProgramResult run_program(const std::vector<std::string>& arguments, const std::string& folder = ".",
                          const Interruption& interruption = {});

/// Runs another program, found along PATH, as run_program does.
ProgramResult run_other(const std::string& program, const std::vector<std::string>& arguments,
                        const std::string& folder = ".");

/// Whether a program is installed; prints why a test is skipped when it is not.
bool is_installed(const std::string& program);

}  // namespace parmesan::support
