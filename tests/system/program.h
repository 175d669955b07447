#pragma once

#include <string>
#include <vector>

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

/// A folder for one test, removed with all its content at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }

  /// The path of a name inside the folder.
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& content) const;

 private:
  std::string path_;
};

/// The content of a file; empty when there is none.
std::string read_file(const std::string& path);

}  // namespace parmesan::support
