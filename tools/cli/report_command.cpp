#include <iostream>
#include <memory>

#include "adapt/report/report.h"
#include "mesher/io/output_file.h"
#include "tools/cli/commands.h"
#include "tools/cli/common_options.h"
#include "tools/cli/escape.h"
#include "tools/cli/exit_code.h"

namespace parmesan {
namespace {

struct ReportArguments {
  std::vector<std::string> folders;
  std::string out;
  CommonOptions common;
};

ExitCode report(const ReportArguments& arguments) {
  apply(arguments.common);
  warn_of_idle_seed(arguments.common);
  std::string path = arguments.out;
  if (!path.empty()) check_output(path);
  if (path.empty()) path = arguments.folders.size() == 1 ? arguments.folders.front() + "/report.html" : "report.html";
  for (const std::string& missing : write_report(path, arguments.folders)) print_warning(missing);
  if (!arguments.common.quiet) std::cout << "written: " << escape_control(path) << "\n";
  return ExitCode::Done;
}

}  // namespace

Command add_report_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("report", "Writes report.html of a run or comparison, or of several");
  const auto arguments = std::make_shared<ReportArguments>();
  app->add_option("DIR", arguments->folders, "Folders of runs and comparisons")->required()->option_text("...");
  app->add_option("-o,--out", arguments->out, "The page [report.html, in the folder when there is only one]")
      ->option_text("FILE");
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan report coarse.out fine.out -o both.html");
  return {app, [arguments] { return report(*arguments); }};
}

}  // namespace parmesan
