#include "tools/cli/progress_to_stderr.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>

#include "tools/cli/escape.h"

namespace parmesan {
namespace {

constexpr std::string_view erase_line = "\r\033[K";

/// The last line of a terminal, while there is something to wait for.
class ProgressBar {
 public:
  ProgressBar() = default;
  ~ProgressBar() {
    if (is_drawn_) std::cerr << erase_line << std::flush;
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const Progress& progress) {
    std::cerr << erase_line << escape_control(progress.line) << '\n';
    draw(progress.share);
    is_drawn_ = true;
  }

 private:
  static void draw(double share) {
    constexpr std::size_t width = 40;
    const auto full = static_cast<std::size_t>(std::lround(share * width));
    std::cerr << '[' << std::string(full, '#') << std::string(width - full, '.') << "] " << std::lround(100.0 * share)
              << " %" << std::flush;
  }

  bool is_drawn_ = false;
};

// One that knows how to erase a line.
bool is_terminal() {
  const char* name = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && name != nullptr && std::string_view(name) != "dumb";
}

}  // namespace

ProgressListener progress_to_stderr(const CommonOptions& common) {
  if (common.quiet) return {};
  if (!is_terminal()) return [](const Progress& progress) { std::cerr << escape_control(progress.line) << std::endl; };
  return [bar = std::make_shared<ProgressBar>()](const Progress& progress) { bar->show(progress); };
}

}  // namespace parmesan
