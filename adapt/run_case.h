#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "adapt/case.h"
#include "adapt/progress.h"
#include "adapt/summary.h"

namespace parmesan {

/// How a case is run; nothing here changes the result but the safety limit.
struct RunOptions {
  std::string out_dir;  // empty: the case's name + ".out"
  bool overwrite = false;
  bool resume = false;                             // go on from the last checkpoint in the folder
  bool force = false;                              // resume though the case is another one
  int threads = 1;                                 // only reported
  ProgressListener progress;                       // gets one line per iteration
  const std::atomic<bool>* interrupted = nullptr;  // looked at between stages
  std::int64_t max_vertices = 10'000'000;          // safety limit, LimitError beyond
};

/// What came of a run.
struct RunResult {
  Summary summary;
  std::string out_dir;            // where the files are
  std::vector<Verdict> verdicts;  // one per "expect" of the case
};

/// The adaptive loop of a case, with its output folder (adapt/README, "The folder of a run").
///
/// Every iteration leaves a checkpoint. With options.resume a run that was interrupted or killed comes to the end
/// it would have come to, bit by bit but for times and memory; one without a checkpoint yet begins anew.
///
/// Errors: InputError (the run to be resumed is of another case), FileError (the folder exists, or cannot be written),
/// ProblemError, GeometryError, MeshingError, SolveError, LimitError; then no final file (mesh.*, summary.json) is
/// left.
RunResult run_case(const Case& input, const RunOptions& options);

/// Compares the last row of a run with the case's pass limits.
///
/// A path leads into the last iteration of summary.json, or into summary.json itself. A value that is absent or null
/// fails.
std::vector<Verdict> verify(const std::vector<Expectation>& expectations, const Summary& summary);

}  // namespace parmesan
