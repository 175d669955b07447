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

/// Wall times of one iteration. Units: s.
struct StageSeconds {
  double mesh = 0.0;
  double solve = 0.0;
  double recover = 0.0;  // Hessians and the metric for the next mesh
  double measure = 0.0;  // error norms and metric statistics
  double cpu = 0.0;      // processor time of mesh, solve and recover, all threads
  double total() const { return mesh + solve + recover + measure; }

  StageSeconds& operator+=(const StageSeconds& other) {
    mesh += other.mesh;
    solve += other.solve;
    recover += other.recover;
    measure += other.measure;
    cpu += other.cpu;
    return *this;
  }
};

}  // namespace parmesan
