#include <iostream>

#include "adapt/case_schema.h"
#include "tools/cli/commands.h"

namespace parmesan {

Command add_schema_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("schema", "The JSON Schema of case files, for editors");
  app->footer("Example: parmesan schema > case.schema.json");
  return {app, [] {
            std::cout << case_schema().dump(2) << "\n";
            return ExitCode::Done;
          }};
}

}  // namespace parmesan
