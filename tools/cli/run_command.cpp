#include <iostream>
#include <memory>

#include "adapt/run_case.h"
#include "tools/cli/case_options.h"
#include "tools/cli/commands.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/naming_file.h"
#include "tools/cli/progress_to_stderr.h"
#include "tools/cli/results.h"

namespace parmesan {
namespace {

struct RunArguments {
  CaseOptions input;
  CommonOptions common;
  bool verify = false;
  bool resume = false;
  bool force = false;
};

RunOptions run_options(const RunArguments& arguments) {
  RunOptions options;
  options.out_dir = arguments.input.out_dir;
  options.overwrite = arguments.input.overwrite;
  options.resume = arguments.resume;
  options.force = arguments.force;
  options.threads = num_threads();
  options.max_vertices = arguments.common.limits.vertices;
  options.progress = progress_to_stderr(arguments.common);
  options.interrupted = &watch_for_interrupt();
  return options;
}

ExitCode run(const RunArguments& arguments) {
  apply(arguments.common);
  const RunResult result = naming_file(arguments.input.file, [&arguments] {
    return run_case(read_case(arguments.input, arguments.common), run_options(arguments));
  });
  for (const std::string& warning : result.summary.warnings) print_warning(warning);
  if (!arguments.common.quiet) print_summary(std::cout, result);
  const Summary& summary = result.summary;
  if (summary.stop_reason == StopReason::Interrupted) return static_cast<ExitCode>(interrupt_exit_code());
  const bool passed = !arguments.verify || all_passed(std::cout, result.verdicts);
  const bool missed = summary.error_targets_declared && !summary.targets_met;
  return passed && !missed ? ExitCode::Done : ExitCode::TargetMissed;
}

}  // namespace

Command add_run_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("run", "The adaptive loop: mesh, solve, estimate, remesh");
  const auto arguments = std::make_shared<RunArguments>();
  add_case_options(*app, arguments->input);
  CLI::Option* resume = app->add_flag("--resume", arguments->resume,
                                      "Go on from the last checkpoint of an interrupted run in the output folder");
  resume->excludes(app->get_option("--overwrite"));
  app->add_flag("--force", arguments->force, "With --resume: though the case has changed")->needs(resume);
  app->add_flag("--verify", arguments->verify, "Check the case's pass limits (\"expect\"); exit 9 when one is missed");
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan run cases/wave_front.json --out wave --set /targets/max_vertices=20000");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace parmesan
