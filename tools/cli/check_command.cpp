#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "adapt/number_text.h"
#include "adapt/trial.h"
#include "tools/cli/case_options.h"
#include "tools/cli/commands.h"
#include "tools/cli/escape.h"
#include "tools/cli/naming_file.h"

namespace parmesan {
namespace {

struct CheckArguments {
  std::vector<std::string> files;
  CommonOptions common;
};

// The size the loop is allowed to reach, as far as the case says, and what memory that takes.
std::string expected_size(const Case& input, const Limits& limits) {
  if (!input.targets.vertices && !input.targets.max_vertices)
    return "its size will follow from the error (the safety limit is " + std::to_string(limits.vertices) + " vertices)";
  const std::int64_t most = input.targets.vertices.value_or(input.targets.max_vertices.value_or(0));
  const std::string count = std::to_string(most) + " vertices";
  const std::string memory = "about " + short_number(std::round(expected_memory_mb(input, most)), 6) + " MB";
  if (input.targets.vertices) return "aims at " + count + ", " + memory;
  return "at most " + count + ", " + memory;
}

std::string trial_text(const IterationRow& row) {
  std::string text = "tried out on " + std::to_string(row.vertices) + " vertices";
  const int free_constants = row.solve_report ? row.solve_report->null_components : 0;
  if (free_constants > 0)
    text += " (the data leave " + std::to_string(free_constants) + (free_constants > 1 ? " constants" : " constant") +
            " free)";
  return text;
}

ExitCode check_one(const std::string& file, const CommonOptions& common) {
  try {
    naming_file(file, [&] {
      const Case input = read_case(file);
      const IterationRow row = try_out(input, common.limits.vertices);
      if (common.quiet) return;
      std::cout << escape_control(file) << ": valid, " << input.domain.points.size() << " points, "
                << input.domain.segments.size() << " segments, " << trial_text(row) << "; "
                << expected_size(input, common.limits) << std::endl;
    });
    return ExitCode::Done;
  } catch (const std::runtime_error&) {
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
  CLI::App* app =
      program.add_subcommand("check", "Validates case files and tries each out on a coarse mesh, without running it");
  const auto arguments = std::make_shared<CheckArguments>();
  app->add_option("CASE", arguments->files, "Case files")->required()->option_text("...");
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan check cases/*.json");
  return {app, [arguments] { return check(*arguments); }};
}

}  // namespace parmesan
