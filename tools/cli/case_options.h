#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "adapt/case.h"
#include "tools/cli/common_options.h"

namespace parmesan {

/// The case file of a subcommand and where its output goes.
struct CaseOptions {
  std::string file;
  std::string out_dir;                // empty: from the case's name
  std::vector<std::string> settings;  // /json/pointer=VALUE
  bool overwrite = false;
};

/// Adds CASE, --out, --set and --overwrite to a subcommand.
void add_case_options(CLI::App& command, CaseOptions& options);

/// The case with the --set values and the --seed in it; described on standard error when verbose. Errors: as
/// read_case(path, overrides).
Case read_case(const CaseOptions& options, const CommonOptions& common);

}  // namespace parmesan
