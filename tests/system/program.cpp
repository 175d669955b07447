#include "tests/system/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <thread>

namespace parmesan::support {
namespace {

int open_for_output(const std::string& path) { return open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600); }

// In the child: never returns.
[[noreturn]] void become_program(std::vector<char*>& arguments, const std::string& folder, int out, int err) {
  const int nothing = open("/dev/null", O_RDONLY);
  if (chdir(folder.c_str()) == 0 && dup2(nothing, 0) == 0 && dup2(out, 1) == 1 && dup2(err, 2) == 2) {
    execvp(arguments.front(), arguments.data());
  }
  _exit(126);
}

int wait_for(pid_t child) {
  int status = 0;
  if (waitpid(child, &status, 0) != child) throw std::runtime_error("waitpid failed");
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// At most a minute: what then is missing, the test finds.
void wait_for_file(const std::string& path) {
  constexpr std::chrono::milliseconds step(5);
  for (int k = 0; k < 12000 && !path.empty() && !std::filesystem::exists(path); ++k) std::this_thread::sleep_for(step);
}

ProgramResult run(const std::string& program, const std::vector<std::string>& arguments, const std::string& folder,
                  const Interruption& interruption) {
  const TemporaryFolder logs;
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int out = open_for_output(logs / "out");
  const int err = open_for_output(logs / "err");
  const pid_t child = fork();
  if (child == 0) become_program(pointers, folder, out, err);
  close(out);
  close(err);
  if (child < 0) throw std::runtime_error("fork failed");
  if (interruption.signal != 0) {
    wait_for_file(interruption.after);
    std::this_thread::sleep_for(std::chrono::milliseconds(interruption.milliseconds));
    kill(child, interruption.signal);
  }
  const int code = wait_for(child);
  return {code, content_of(logs / "out"), content_of(logs / "err")};
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& arguments, const std::string& folder,
                          const Interruption& interruption) {
  return run(PARMESAN_PROGRAM, arguments, folder, interruption);
}

ProgramResult run_other(const std::string& program, const std::vector<std::string>& arguments,
                        const std::string& folder) {
  return run(program, arguments, folder, {});
}

bool is_installed(const std::string& program) {
  if (run_other("which", {program}).exit_code == 0) return true;
  std::cout << "skipped: there is no " << program << "\n";
  return false;
}

}  // namespace parmesan::support
