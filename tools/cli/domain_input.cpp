#include "tools/cli/domain_input.h"

#include <utility>

#include "adapt/io/any_geometry.h"
#include "tools/cli/exit_code.h"

namespace parmesan {

void add_repair_option(CLI::App& command, bool& repair) {
  command.add_flag("--repair", repair, "Split segments where they cross instead of refusing the geometry");
}

Domain read_domain(const std::string& path, bool repair) {
  Domain domain = read_any_geometry(path);
  if (!repair) return domain;
  CleanDomain result = clean(domain, Crossings::Split);
  for (const std::string& sentence : result.repairs) print_warning(sentence);
  return std::move(result.domain);
}

}  // namespace parmesan
