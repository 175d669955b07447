#include "tools/cli/case_options.h"

#include <iostream>

#include "tools/cli/escape.h"

namespace parmesan {
namespace {

std::string check_setting(const std::string& text) {
  const bool fits = !text.empty() && text.front() == '/' && text.find('=') != std::string::npos;
  return fits ? "" : "'" + text + "' is not of the form /json/pointer=VALUE";
}

std::string description(const Case& input) {
  return input.name + ": " + std::to_string(input.domain.points.size()) + " points, " +
         std::to_string(input.domain.segments.size()) + " segments, " + (input.interpolation ? "a function" : "a PDE") +
         ", seed " + std::to_string(input.mesher.seed);
}

}  // namespace

void add_case_options(CLI::App& command, CaseOptions& options) {
  command.add_option("CASE", options.file, "The case file")->required()->option_text(" ");
  command.add_option("-o,--out", options.out_dir, "Folder for the output [named after the case]")->option_text("DIR");
  command.add_option("--set", options.settings, "Replaces a value of the case, e.g. /targets/max_iterations=5")
      ->option_text("/POINTER=VALUE ...")
      ->take_all()
      ->allow_extra_args(false)
      ->check(check_setting);
  command.add_flag("--overwrite", options.overwrite, "Replace the output of an earlier run");
}

Case read_case(const CaseOptions& options, const CommonOptions& common) {
  std::vector<Override> overrides;
  for (const std::string& text : options.settings) {
    const NameValue pair = split_name_value(text, "--set");
    overrides.push_back({pair.name, pair.value});
  }
  if (common.seed) overrides.push_back({"/mesher/seed", std::to_string(*common.seed)});
  Case result = read_case(options.file, overrides);
  warn_of_idle_seed(common, result.mesher.schedule);
  if (common.verbose) std::cerr << escape_control(description(result)) << std::endl;
  return result;
}

}  // namespace parmesan
