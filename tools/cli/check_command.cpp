#include <cmath>
#include <iostream>
#include <memory>

#include "tools/cli/case_options.h"
#include "tools/cli/commands.h"
#include "tools/cli/escape.h"

namespace parmesan {
namespace {

struct CheckArguments {
  std::vector<std::string> files;
  CommonOptions common;
};

// The size the loop is allowed to reach, as far as the case says.
std::string expected_size(const Case& input, const Limits& limits) {
  const auto count = [](std::int64_t n) { return std::to_string(n) + " vertices"; };
  if (input.targets.vertices) return "aims at " + count(*input.targets.vertices);
  if (input.targets.max_vertices) return "at most " + count(*input.targets.max_vertices);
  return "at most " + count(limits.vertices) + " (the safety limit)";
}

ExitCode check_one(const std::string& file, const CommonOptions& common) {
  try {
    const Case input = read_case(file);
    if (!common.quiet) {
      std::cout << escape_control(file) << ": valid, " << input.domain.points.size() << " points, "
                << input.domain.segments.size() << " segments, " << expected_size(input, common.limits) << std::endl;
    }
    return ExitCode::Done;
  } catch (const InputError&) {
    return report_current_exception();
  }
}

ExitCode check(const CheckArguments& arguments) {
  apply(arguments.common);
  ExitCode first_problem = ExitCode::Done;
  for (const std::string& file : arguments.files) {
    const ExitCode code = check_one(file, arguments.common);
    if (first_problem == ExitCode::Done) first_problem = code;
  }
  return first_problem;
}

}  // namespace

Command add_check_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("check", "Validates case files without running them");
  const auto arguments = std::make_shared<CheckArguments>();
  app->add_option("CASE", arguments->files, "Case files")->required()->option_text("...");
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan check cases/*.json");
  return {app, [arguments] { return check(*arguments); }};
}

}  // namespace parmesan
