#include <iostream>
#include <memory>

#include "adapt/case_schema.h"
#include "adapt/schema_page.h"
#include "tools/cli/commands.h"
#include "tools/cli/common_options.h"

namespace parmesan {
namespace {

struct SchemaArguments {
  bool markdown = false;
  CommonOptions common;
};

ExitCode print_schema(const SchemaArguments& arguments) {
  apply(arguments.common);
  warn_of_idle_seed(arguments.common);
  std::cout << (arguments.markdown ? case_schema_page() : case_schema().dump(2) + "\n");
  return ExitCode::Done;
}

}  // namespace

Command add_schema_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("schema", "The JSON Schema of case files, for editors");
  const auto arguments = std::make_shared<SchemaArguments>();
  app->add_flag("--markdown", arguments->markdown, "The same as tables to read, in Markdown");
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan schema > case.schema.json");
  return {app, [arguments] { return print_schema(*arguments); }};
}

}  // namespace parmesan
