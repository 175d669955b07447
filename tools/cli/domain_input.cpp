#include "tools/cli/domain_input.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "adapt/case.h"
#include "adapt/region_names.h"
#include "mesher/errors.h"
#include "mesher/generate_around.h"
#include "mesher/geometry/clean.h"
#include "mesher/io/text.h"
#include "tools/cli/common_options.h"
#include "tools/cli/exit_code.h"

namespace parmesan {

void add_repair_options(CLI::App& command, RepairOptions& options) {
  command.add_flag("--repair", options.split_crossings,
                   "Split segments where they cross instead of refusing the geometry");
  command
      .add_option("--merge-tolerance", options.merge_tolerance,
                  "Merge points of the geometry nearer than this, and bend segments to points as near")
      ->check(positive_number())
      ->option_text("D");
}

namespace {

/// Also the geometry of a case file.
GeometryInput read_input(const std::string& path, const RepairOptions& options) {
  if (file_suffix(path) == ".json")
    if (std::optional<GeometryInput> input = read_case_geometry(path, options.merge_tolerance))
      return std::move(*input);
  return read_geometry_input(path, options.split_crossings ? Crossings::Split : Crossings::Refuse,
                             options.merge_tolerance);
}

/// What those who take a mended domain will find and say too.
std::vector<std::string> found_again(const Domain& domain) {
  try {
    return clean(domain).repairs;
  } catch (const GeometryError&) {
    return {};
  }
}

Domain repaired(Domain domain, const RepairOptions& options) {
  if (!options.split_crossings && domain.merge_tolerance == 0.0) return domain;
  CleanDomain result = clean(domain, options.split_crossings ? Crossings::Split : Crossings::Refuse);
  const std::vector<std::string> again = found_again(result.domain);
  for (const std::string& sentence : result.repairs)
    if (std::ranges::find(again, sentence) == again.end()) print_warning(sentence);
  return std::move(result.domain);
}

}  // namespace

bool keeps_triangles(const GeometryInput& geometry) {
  return geometry.mesh && !geometry.mesh->required.triangles.empty();
}

Domain read_domain(const std::string& path, const RepairOptions& options) {
  return repaired(read_input(path, options).domain, options);
}

GeometryInput read_geometry_to_mesh(const std::string& path, const RepairOptions& options,
                                    const std::vector<std::string>& regions) {
  GeometryInput input = read_input(path, options);
  if (!regions.empty() && !input.mesh)
    throw GeometryError("--freeze: the geometry is no mesh, so it has no triangles that could stay");
  if (!regions.empty()) {
    const auto refuse = [](std::size_t, const std::string& problem) { throw GeometryError("--freeze: " + problem); };
    const std::vector<int> required =
        regions_named(regions, regions_by_name(input.mesh->region_names, input.mesh->regions), refuse);
    input.mesh = with_required_regions(std::move(*input.mesh), required);
  }
  if (!keeps_triangles(input)) {
    input.domain = repaired(std::move(input.domain), options);
  } else if (options.merge_tolerance > 0.0) {
    throw GeometryError("--merge-tolerance: the geometry has triangles that are required to stay as they are");
  }
  return input;
}

}  // namespace parmesan
