#include "tools/cli/thesis_options.h"

#include <map>
#include <memory>
#include <string>

namespace parmesan {
namespace {

constexpr const char* group = "Parameters of --schedule thesis";

template <class T, std::size_t N>
void add_choice(CLI::App& command, const char* name, T& value, const std::array<OptionName<T>, N>& names,
                const std::string& help) {
  std::map<std::string, T> choices;
  std::string list;
  std::string chosen;
  for (const auto& [word, meaning] : names) {
    choices.emplace(word, meaning);
    list += (list.empty() ? "" : ", ") + std::string(word);
    if (meaning == value) chosen = word;
  }
  command.add_option(name, value, help + ": " + list + " [" + chosen + "]")
      ->transform(CLI::CheckedTransformer(choices))
      ->option_text("NAME")
      ->group(group);
}

struct Range {
  double min;
  double max;
};

void add_number(CLI::App& command, const char* name, double& value, const Range& range, const std::string& help) {
  command.add_option(name, value, help)->check(CLI::Range(range.min, range.max))->option_text("X")->group(group);
}

}  // namespace

void add_schedule_options(CLI::App& command, GenerateOptions& options) {
  const std::map<std::string, Schedule> schedules{{"fast", Schedule::Fast}, {"thesis", Schedule::Thesis}};
  command.add_option("--schedule", options.schedule, "How particles are moved: fast, or thesis, pick by pick [fast]")
      ->transform(CLI::CheckedTransformer(schedules))
      ->option_text("NAME");
  ThesisOptions& thesis = options.thesis;
  add_choice(command, "--potential", thesis.potential, potential_names, "What acts between particles (3.3)");
  add_number(command, "--decay", thesis.decay, {1e-6, 100.0}, "d of the approximation 3.20 [1]");
  add_choice(command, "--neighbourhood", thesis.neighbourhood, neighbourhood_names, "Who acts on whom (3.2)");
  add_number(command, "--radius", thesis.radius, {1.0, 10.0}, "In unit edges, for --neighbourhood radius [1.5]");
  add_choice(command, "--force", thesis.force, force_names, "5.15 or 5.16");
  add_choice(command, "--distance", thesis.distance, distance_names, "5.6, 5.7 or 5.8");
  add_number(command, "--step", thesis.step, {0.0, 10.0}, "delta of 3.12 [0: Newton's on the hexagonal lattice]");
  add_number(command, "--momentum", thesis.momentum, {0.0, 0.99}, "beta of 3.13 [0: first order]");
  add_number(command, "--alive-speed", thesis.alive_speed, {1e-9, 0.99},
             "Slower particles die, in unit edges per pick [0.01]");
  add_choice(command, "--creation", thesis.creation, creation_names, "Where particles are created");
  add_choice(command, "--annihilation", thesis.annihilation, annihilation_names, "How particles go");
  add_choice(command, "--relocation", thesis.relocation, relocation_names, "How particles move");
  add_choice(command, "--picking", thesis.picking, picking_names, "Who is picked (3.5)");
  add_number(command, "--max-picks", thesis.max_picks, {1.0, 1e9}, "Most picks per particle [400]");
  command
      .add_flag_callback(
          "--no-virtual-triangles", [&thesis] { thesis.virtual_triangles = false; },
          "Without them in the creation rule (3.4.2)")
      ->group(group);
}

}  // namespace parmesan
