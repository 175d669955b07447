#include <iostream>
#include <memory>

#include "adapt/case_schema.h"
#include "adapt/schema_page.h"
#include "tools/cli/commands.h"

namespace parmesan {

Command add_schema_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("schema", "The JSON Schema of case files, for editors");
  const auto markdown = std::make_shared<bool>(false);
  app->add_flag("--markdown", *markdown, "The same as tables to read, in Markdown");
  app->footer("Example: parmesan schema > case.schema.json");
  return {app, [markdown] {
            std::cout << (*markdown ? case_schema_page() : case_schema().dump(2) + "\n");
            return ExitCode::Done;
          }};
}

}  // namespace parmesan
