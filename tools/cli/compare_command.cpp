#include <iostream>
#include <memory>

#include "adapt/compare.h"
#include "tools/cli/case_options.h"
#include "tools/cli/commands.h"
#include "tools/cli/common_options.h"
#include "tools/cli/escape.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/naming_file.h"
#include "tools/cli/progress_to_stderr.h"

namespace parmesan {
namespace {

struct CompareArguments {
  CaseOptions input;
  CommonOptions common;
  std::vector<std::int64_t> sizes;
};

CompareOptions compare_options(const CompareArguments& arguments) {
  CompareOptions options;
  options.out_dir = arguments.input.out_dir;
  options.overwrite = arguments.input.overwrite;
  if (!arguments.sizes.empty()) options.sizes = arguments.sizes;
  options.max_vertices = arguments.common.limits.vertices;
  options.progress = progress_to_stderr(arguments.common);
  options.interrupted = &watch_for_interrupt();
  return options;
}

ExitCode compare(const CompareArguments& arguments) {
  apply(arguments.common);
  const CompareResult result = naming_file(arguments.input.file, [&arguments] {
    return compare_case(read_case(arguments.input, arguments.common), compare_options(arguments));
  });
  if (result.out_dir.empty()) print_warning("interrupted before the first mesh; nothing is written");
  if (!arguments.common.quiet && !result.out_dir.empty()) {
    std::cout << escape_control(result.table, true) << "written: " << escape_control(result.out_dir)
              << ", to be looked at in its report.html\n";
  }
  return result.interrupted ? static_cast<ExitCode>(interrupt_exit_code()) : ExitCode::Done;
}

}  // namespace

Command add_compare_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("compare", "One problem on anisotropic, isotropic and uniform meshes of growing size");
  const auto arguments = std::make_shared<CompareArguments>();
  add_case_options(*app, arguments->input);
  app->add_option("--sizes", arguments->sizes, "Numbers of vertices, ascending [1000,4000,16000,64000]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}))
      ->option_text("N,...");
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan compare cases/wave_front.json --sizes 1000,4000,16000");
  return {app, [arguments] { return compare(*arguments); }};
}

}  // namespace parmesan
