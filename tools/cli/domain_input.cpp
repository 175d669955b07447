#include "tools/cli/domain_input.h"

#include <optional>
#include <utility>

#include "adapt/case.h"
#include "adapt/io/any_geometry.h"
#include "mesher/io/text.h"
#include "tools/cli/exit_code.h"

namespace parmesan {

void add_repair_option(CLI::App& command, bool& repair) {
  command.add_flag("--repair", repair, "Split segments where they cross instead of refusing the geometry");
}

Domain read_domain(const std::string& path, bool repair) {
  std::optional<Domain> of_case;
  if (file_suffix(path) == ".json") of_case = read_case_domain(path);
  Domain domain = of_case ? std::move(*of_case) : read_any_geometry(path);
  if (!repair) return domain;
  CleanDomain result = clean(domain, Crossings::Split);
  for (const std::string& sentence : result.repairs) print_warning(sentence);
  return std::move(result.domain);
}

}  // namespace parmesan
