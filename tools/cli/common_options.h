#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesher/generate.h"

namespace parmesan {

/// Safety limits: set on the command line, never by a case file. 0: none.
struct Limits {
  std::int64_t vertices = 10'000'000;
  std::int64_t memory_mb = 0;  // 0: nine tenths of the machine's memory
  std::int64_t seconds = 0;
};

/// Options that every subcommand takes.
struct CommonOptions {
  bool quiet = false;
  bool verbose = false;
  std::optional<std::uint64_t> seed;
  int threads = 0;  // 0: all cores
  Limits limits;
};

/// Adds --quiet, --verbose, --threads, --seed, --limit and --version to a subcommand. options must outlive it.
void add_common_options(CLI::App& command, CommonOptions& options);

/// Says so where a seed is given to a schedule, or to a command, that draws no random numbers.
void warn_of_idle_seed(const CommonOptions& options, Schedule schedule = Schedule::Fast);

/// Puts the limits of memory and time on this process, and the number of threads.
/// Past the time limit the process ends with ExitCode::LimitHit.
void apply(const CommonOptions& options);

/// With how many threads this process computes, after apply.
int num_threads();

/// Checks for a number above 0 whose square is no less and no more than a double can be.
CLI::Validator positive_number();

/// A "name=value" pair of an option such as --limit. Errors: CLI::ValidationError without "=".
struct NameValue {
  std::string name;
  std::string value;
};
NameValue split_name_value(const std::string& text, const std::string& option);

/// Numbers of an option's value. Errors: CLI::ValidationError unless positive (or in [0, 1]) and finite.
std::int64_t parse_positive_integer(const std::string& text, const std::string& option);
double parse_share(const std::string& text, const std::string& option);

}  // namespace parmesan
