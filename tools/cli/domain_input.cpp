#include "tools/cli/domain_input.h"

#include <map>
#include <optional>
#include <utility>

#include "adapt/case.h"
#include "adapt/nearest_name.h"
#include "mesher/errors.h"
#include "mesher/generate_around.h"
#include "mesher/io/text.h"
#include "tools/cli/exit_code.h"

namespace parmesan {

void add_repair_option(CLI::App& command, bool& repair) {
  command.add_flag("--repair", repair, "Split segments where they cross instead of refusing the geometry");
}

namespace {

/// Also the geometry of a case file.
GeometryInput read_input(const std::string& path) {
  if (file_suffix(path) == ".json")
    if (std::optional<Domain> domain = read_case_domain(path)) return {std::move(*domain), std::nullopt};
  return read_geometry_input(path);
}

Domain repaired(const Domain& domain) {
  CleanDomain result = clean(domain, Crossings::Split);
  for (const std::string& sentence : result.repairs) print_warning(sentence);
  return std::move(result.domain);
}

std::vector<int> regions_named(const Mesh& mesh, const std::vector<std::string>& names) {
  std::map<std::string, int> present;
  for (const int region : ascending(mesh.regions)) present.emplace(label_name(mesh.region_names, region), region);
  std::vector<std::string> known;
  for (const auto& [name, region] : present) known.push_back(name);
  std::vector<int> regions;
  for (const std::string& name : names) {
    const auto found = present.find(name);
    if (found != present.end()) {
      regions.push_back(found->second);
      continue;
    }
    const std::string hint = suggestion(name, known);
    throw GeometryError("--freeze: there is no region '" + name + "'" + (hint.empty() ? "." : hint) +
                        " The regions are: " + quoted_list(known));
  }
  return regions;
}

}  // namespace

Domain read_domain(const std::string& path, bool repair) {
  Domain domain = read_input(path).domain;
  return repair ? repaired(domain) : std::move(domain);
}

GeometryInput read_geometry_to_mesh(const std::string& path, bool repair, const std::vector<std::string>& regions) {
  GeometryInput input = read_input(path);
  if (repair) input.domain = repaired(input.domain);
  if (!regions.empty() && !input.mesh)
    throw GeometryError("--freeze: the geometry is no mesh, so it has no triangles that could stay");
  if (!regions.empty()) {
    const std::vector<int> required = regions_named(*input.mesh, regions);
    input.mesh = with_required_regions(std::move(*input.mesh), required);
  }
  return input;
}

}  // namespace parmesan
