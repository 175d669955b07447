#include "tools/cli/usage_error.h"

#include <algorithm>
#include <string>
#include <vector>

#include "adapt/nearest_name.h"
#include "tools/cli/choice.h"

namespace parmesan {
namespace {

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> subcommands_of(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* app : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(app->get_name());
  return names;
}

void check_name(const std::string& option, const std::string& name) {
  if (name.empty()) throw CLI::ValidationError(option, "is empty");
  if (option == "--out" && name == "-")
    throw CLI::ValidationError(option, "'-' does not stand for standard output; ./- is a file of this name");
}

bool is_option(const std::string& word) { return word.size() > 1 && word.front() == '-' && word != "--"; }

// Options belong to subcommands. Empty: none stands before the chosen one.
std::string explain_misplaced(const CLI::App& program, const CLI::App& chosen) {
  const std::vector<std::string> before = program.remaining();
  const auto option = std::ranges::find_if(before, is_option);
  if (&chosen == &program || option == before.end()) return "";
  const std::string name = option->substr(0, option->find('='));
  if (chosen.get_option_no_throw(name) == nullptr)
    return "unknown option '" + name + "'" + suggestion(name, options_of(chosen));
  return "'" + name + "' is an option of '" + chosen.get_name() + "' and comes after it";
}

// An option that is not known comes first: what else is missing or too much follows from it, and CLI11 speaks of that.
std::string explain(const CLI::App& program, const CLI::App& app, const CLI::ParseError& error) {
  if (std::string misplaced = explain_misplaced(program, app); !misplaced.empty()) return misplaced;
  const std::vector<std::string> rest = app.remaining();
  if (&app == &program && !rest.empty() && !is_option(rest.front()))
    return none_of(rest.front(), subcommands_of(program));
  const auto unknown = std::ranges::find_if(rest, is_option);
  if (unknown == rest.end()) return error.what();
  const std::string name = unknown->substr(0, unknown->find('='));
  return "unknown option '" + name + "'" + suggestion(name, options_of(app));
}

}  // namespace

void check_names(const CLI::App& program) {
  for (const CLI::App* app : program.get_subcommands())
    for (const CLI::Option* option : app->get_options())
      for (const std::string& value : option->results()) check_name(option->get_name(), value);
}

ExitCode report_usage_error(const CLI::App& program, const CLI::ParseError& error) {
  const auto chosen = program.get_subcommands();
  const CLI::App& app = chosen.empty() ? program : *chosen.front();
  const std::string name = chosen.empty() ? "" : app.get_name() + " ";
  print_error(explain(program, app, error) + "\nsee: parmesan " + name + "--help");
  return ExitCode::Usage;
}

}  // namespace parmesan
