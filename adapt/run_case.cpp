#include "adapt/run_case.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "adapt/adapt_loop.h"
#include "adapt/checkpoint.h"
#include "adapt/loop_decision.h"
#include "adapt/measure.h"
#include "adapt/number_text.h"
#include "adapt/outputs.h"
#include "adapt/report/report.h"
#include "mesher/errors.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

std::string progress_line(const Case& input, const IterationRow& row) {
  const ErrorNorms error = targeted_error(input, row);
  const bool estimated = !input.interpolation && !row.solution_error;
  std::string line = padded(std::to_string(row.iteration), 3) + padded(std::to_string(row.vertices), 9) +
                     " vertices  " + (estimated ? "estimated L2 " : "L2 ") + short_number(error.l2, 3) + "  H1 " +
                     short_number(error.h1, 3);
  if (row.goal) {
    line +=
        "  goal " + short_number(row.goal->value, 6) + " (error ~" + short_number(row.goal->estimate.error, 2) + ")";
  }
  if (row.efficiency) line += "  efficiency " + short_number(*row.efficiency, 3);
  line += "  unit edges " + short_number(100.0 * row.unit_edges, 3) + " %  quality " +
          short_number(row.quality_mean, 3) + " (min " + short_number(row.quality_min, 2) + ")  " +
          short_number(row.seconds.total(), 2) + " s";
  return line;
}

// Null when absent.
Json member(const Json& parent, const std::vector<std::string>& path) {
  const Json* value = &parent;
  for (const std::string& name : path) {
    if (!value->is_object() || !value->contains(name)) return nullptr;
    value = &(*value)[name];
  }
  return *value;
}

// The value in the last iteration, else in the summary itself; null when absent.
Json value_of(const std::vector<std::string>& path, const Json& summary) {
  const Json& rows = summary["iterations"];
  const Json of_row = rows.empty() ? Json(nullptr) : member(rows.back(), path);
  return of_row.is_null() ? member(summary, path) : of_row;
}

std::string dotted(const std::vector<std::string>& path) {
  std::string text;
  for (const std::string& name : path) text += (text.empty() ? "" : ".") + name;
  return text;
}

std::string limits_text(const Expectation& expected) {
  std::string text;
  if (expected.min) text += ", min " + short_number(*expected.min, 6);
  if (expected.max) text += ", max " + short_number(*expected.max, 6);
  if (expected.equals) text += std::string(", expected ") + (*expected.equals ? "true" : "false");
  return text;
}

Verdict verdict(const Expectation& expected, const Json& summary) {
  const std::string name = dotted(expected.path);
  const Json value = value_of(expected.path, summary);
  bool passed = true;
  if (expected.min || expected.max) {
    passed = value.is_number() && (!expected.min || value.get<double>() >= *expected.min) &&
             (!expected.max || value.get<double>() <= *expected.max);
  }
  if (expected.equals) passed = passed && value.is_boolean() && value.get<bool>() == *expected.equals;
  return {name, passed, name + " = " + value.dump() + limits_text(expected)};
}

void say(const RunOptions& options, std::string line, double share = 0.0) {
  if (options.progress) options.progress({std::move(line), share});
}

// What a run that is gone on with must agree in: the case, and what the files that it names hold.
std::uint64_t checksum_of(const Case& input) {
  std::string text = input.resolved.dump();
  for (const std::string& file : input.files) text += "\n" + std::to_string(checksum(read_file(file)));
  return checksum(text);
}

struct Resumed {
  LoopState state;
  bool is_other_case = false;
};

// Nothing where the run was ended before its first checkpoint, or has not begun.
std::optional<Resumed> state_to_resume(const std::string& path, const Case& input, std::uint64_t case_hash,
                                       const RunOptions& options) {
  FoundCheckpoint found = find_checkpoint(path);
  for (const std::string& problem : found.problems) say(options, problem);
  if (!found.checkpoint) {
    if (!found.problems.empty())
      throw FileError(path, 0,
                      "no checkpoint can be used: " + found.problems.back() + "; --overwrite replaces the run");
    std::error_code unreadable;
    if (std::filesystem::exists(path + "/summary.json", unreadable))
      throw FileError(path, 0, "this run has no checkpoint to go on from; --overwrite replaces it");
    say(options, "there is no checkpoint to go on from: starting anew");
    return std::nullopt;
  }
  const bool is_other_case = found.checkpoint->case_hash != case_hash;
  if (is_other_case && !options.force) {
    throw InputError(path + " holds the run of another case than this one (compare its case.json" +
                     (input.files.empty() ? "" : ", and the files that the case names") +
                     "); --force goes on with this case from there");
  }
  say(options,
      "going on after iteration " + std::to_string(found.checkpoint->state.summary.iterations.back().iteration));
  return Resumed{std::move(found.checkpoint->state), is_other_case};
}

EarlierFiles earlier_files(const RunOptions& options, bool resumed) {
  if (resumed) return EarlierFiles::GoOn;
  return options.overwrite || options.resume ? EarlierFiles::Replace : EarlierFiles::Refuse;
}

}  // namespace

std::vector<Verdict> verify(const std::vector<Expectation>& expectations, const Summary& summary) {
  const Json json = to_json(summary);
  std::vector<Verdict> verdicts;
  verdicts.reserve(expectations.size());
  for (const Expectation& expected : expectations) verdicts.push_back(verdict(expected, json));
  return verdicts;
}

RunResult run_case(const Case& input, const RunOptions& options) {
  const std::string path = options.out_dir.empty() ? input.name + ".out" : options.out_dir;
  const std::uint64_t case_hash = checksum_of(input);
  const std::optional<Resumed> resumed =
      options.resume ? state_to_resume(path, input, case_hash, options) : std::nullopt;
  RunFolder folder(path, input, earlier_files(options, resumed.has_value()));
  LoopOptions loop;
  loop.threads = options.threads;
  loop.max_vertices = options.max_vertices;
  loop.interrupted = options.interrupted;
  loop.observer = [&](const LoopState& state) {
    const IterationRow& row = state.summary.iterations.back();
    folder.write_iteration(state.last, row);
    write_checkpoint(path, state, case_hash);
    say(options, progress_line(input, row), share_of_way(state.history, size_goal(input.targets)));
  };
  LoopResult run = adapt(
      input, loop, {.resume = resumed ? &resumed->state : nullptr, .is_other_case = resumed && resumed->is_other_case});
  folder.finish(run.summary, run.last);
  write_report(path + "/report.html", {path});
  RunResult result;
  result.out_dir = folder.path();
  result.verdicts = verify(input.expect, run.summary);
  result.summary = std::move(run.summary);
  return result;
}

}  // namespace parmesan
