#pragma once

#include <chrono>
#include <ctime>

namespace parmesan {

/// Time since it was made.
class Stopwatch {
 public:
  /// Wall time. Units: s.
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  /// Processor time of all threads. Units: s.
  double cpu_seconds() const { return static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC; }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::clock_t cpu_start_ = std::clock();
};

}  // namespace parmesan
