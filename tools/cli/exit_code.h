#pragma once

#include <string>

namespace parmesan {

/// How the program ends.
enum class ExitCode {
  Done = 0,
  Bug = 1,
  Usage = 2,
  BadCase = 3,
  BadGeometry = 4,
  NoMesh = 5,
  NoSolution = 6,
  FileProblem = 7,
  LimitHit = 8,
  TargetMissed = 9,
  Interrupted = 130
};

/// Prints "parmesan: error: ..." for the exception being handled and gives the exit code of its type. To be called in a
/// catch block only.
ExitCode report_current_exception();

/// Print "parmesan: error: ..." or "parmesan: warning: ..." to standard error, control characters escaped.
void print_error(const std::string& message);
void print_warning(const std::string& message);

}  // namespace parmesan
