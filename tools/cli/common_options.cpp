#include "tools/cli/common_options.h"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <string_view>

#include "tools/cli/choice.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/version.h"

#ifdef _OPENMP
#include <omp.h>
#endif

namespace parmesan {
namespace {

template <class T>
std::optional<T> parse_number(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

void set_limit(Limits& limits, const std::string& text) {
  constexpr std::array<OptionName<std::int64_t Limits::*>, 3> names{
      {{"vertices", &Limits::vertices}, {"memory_mb", &Limits::memory_mb}, {"seconds", &Limits::seconds}}};
  const NameValue pair = split_name_value(text, "--limit");
  std::int64_t Limits::*const limit = choose("--limit", pair.name, names);
  limits.*limit = parse_positive_integer(pair.value, "--limit " + pair.name);
}

// With their stacks, threads that are started later would not fit into a small limit, which OpenMP reports by ending
// the program.
void start_threads() {
#ifdef _OPENMP
  std::atomic<int> num_started = 0;
#pragma omp parallel
  ++num_started;
#endif
}

// Beyond the limit operator new throws std::bad_alloc, which ends the program in an orderly way.
void limit_memory([[maybe_unused]] std::int64_t megabytes) {
#ifndef PARMESAN_SANITIZE  // the shadow memory of AddressSanitizer counts
  const auto pages = static_cast<rlim_t>(std::max(0L, sysconf(_SC_PHYS_PAGES)));
  const rlim_t machine = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) / 10 * 9;
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
  const rlim_t wanted = megabytes > 0 ? static_cast<rlim_t>(megabytes) << 20 : machine;
  if (wanted == 0 || wanted > limit.rlim_max) return;
  limit.rlim_cur = wanted;
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

extern "C" void stop_at_time_limit(int) {
  constexpr std::string_view message = "parmesan: error: the time allowed by --limit seconds is over\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
  _exit(static_cast<int>(ExitCode::LimitHit));
}

void limit_time(std::int64_t seconds) {
  if (seconds == 0) return;
  signal(SIGALRM, stop_at_time_limit);
  alarm(static_cast<unsigned>(std::min<std::int64_t>(seconds, 1'000'000'000)));
}

}  // namespace

CLI::Validator positive_number() {
  return {[](const std::string& text) {
            constexpr double least = 1e-150, most = 1e150;
            double value = 0.0;
            const bool is_number = CLI::detail::lexical_cast(text, value);
            return is_number && value >= least && value <= most ? std::string()
                                                                : "must be a number from 1e-150 to 1e150, not " + text;
          },
          "POSITIVE"};
}

NameValue split_name_value(const std::string& text, const std::string& option) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw CLI::ValidationError(option, "'" + text + "' is not of the form name=value");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::int64_t parse_positive_integer(const std::string& text, const std::string& option) {
  const auto value = parse_number<std::int64_t>(text);
  if (!value || *value <= 0) throw CLI::ValidationError(option, "'" + text + "' is not a positive whole number");
  return *value;
}

double parse_share(const std::string& text, const std::string& option) {
  const auto value = parse_number<double>(text);
  if (!value || !(*value >= 0.0 && *value <= 1.0)) {
    throw CLI::ValidationError(option, "'" + text + "' is not a number from 0 to 1");
  }
  return *value;
}

void add_common_options(CLI::App& command, CommonOptions& options) {
  constexpr const char* group = "Common options";
  command.add_flag("-q,--quiet", options.quiet, "No log, no summary")->group(group);
  command.add_flag("-v,--verbose", options.verbose, "More log")->group(group);
  command.add_option("--threads", options.threads, "Threads [all cores]; the result does not depend on it")
      ->check(CLI::Range(1, 4096))
      ->option_text("N")
      ->group(group);
  command.add_option("--seed", options.seed, "Seed of the random engine, from which only the schedule thesis draws")
      ->option_text("N")
      ->group(group);
  command
      .add_option_function<std::vector<std::string>>(
          "--limit",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) set_limit(options.limits, text);
          },
          "Safety limit: vertices=N [10000000], memory_mb=N [9/10 of the machine], seconds=N [none]")
      ->option_text("NAME=N")
      ->take_all()
      ->allow_extra_args(false)
      ->group(group);
  command.set_version_flag("--version", version_text, "Print version, compiler and features");
}

void warn_of_idle_seed(const CommonOptions& options, Schedule schedule) {
  if (options.seed && schedule != Schedule::Thesis)
    print_warning("--seed has no effect: only the schedule 'thesis' draws random numbers");
}

int num_threads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

void apply(const CommonOptions& options) {
#ifdef _OPENMP
  if (options.threads > 0) omp_set_num_threads(options.threads);
#endif
  if (options.limits.memory_mb > 0) start_threads();
  limit_memory(options.limits.memory_mb);
  limit_time(options.limits.seconds);
}

}  // namespace parmesan
