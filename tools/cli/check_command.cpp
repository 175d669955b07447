#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "adapt/number_text.h"
#include "adapt/targets.h"
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

std::string size_text(const Case& input, std::int64_t vertices) {
  const double memory = std::round(expected_memory_mb(input, vertices));
  return std::to_string(vertices) + " vertices, about " + short_number(memory, 6) + " MB";
}

// The size that the loop will reach, or may reach, as far as that is known, and what memory it takes.
std::string expected_size(const Case& input, const Trial& trial, const Limits& limits) {
  const Targets& targets = input.targets;
  if (targets.vertices && !declares_error_target(targets)) return "aims at " + size_text(input, *targets.vertices);
  const std::int64_t most =
      std::min(targets.vertices.value_or(limits.vertices), targets.max_vertices.value_or(limits.vertices));
  if (trial.least_vertices && *trial.least_vertices > static_cast<double>(most))
    return "the L2 error aimed at takes about " + short_number(*trial.least_vertices, 2) + " vertices, more than the " +
           std::to_string(most) + " allowed";
  std::string text;
  if (trial.least_vertices)
    text = "the L2 error aimed at takes at least about " + size_text(input, std::llround(*trial.least_vertices)) + "; ";
  if (targets.vertices || targets.max_vertices) return text + "at most " + size_text(input, most);
  if (text.empty()) text = "its size will follow from the error; ";
  return text + "the safety limit is " + std::to_string(limits.vertices) + " vertices";
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
      CaseOptions options;
      options.file = file;
      const Case input = read_case(options, common);
      const Trial trial = try_out(input, common.limits.vertices);
      if (common.quiet) return;
      std::cout << escape_control(file) << ": valid, " << input.domain.points.size() << " points, "
                << input.domain.segments.size() << " segments, " << trial_text(trial.row) << "; "
                << expected_size(input, trial, common.limits) << std::endl;
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
