#include "tools/cli/particle_options.h"

#include <map>
#include <memory>
#include <string>

namespace parmesan {
namespace {

constexpr const char* group = "Particles (numbers are equations and sections of the thesis)";

// Value: T, or an optional one where the schedule has its own.
template <class Value, class T, std::size_t N>
CLI::Option* add_choice(CLI::App& command, const char* name, Value& value, const std::array<OptionName<T>, N>& names,
                        const std::string& help) {
  std::map<std::string, T> choices;
  std::string list;
  std::string chosen = "the schedule's";
  for (const auto& [word, meaning] : names) {
    choices.emplace(word, meaning);
    list += (list.empty() ? "" : ", ") + std::string(word);
    if (value == meaning) chosen = word;
  }
  return command.add_option(name, value, help + ": " + list + " [" + chosen + "]")
      ->transform(CLI::CheckedTransformer(choices))
      ->option_text("NAME")
      ->group(group);
}

struct Range {
  double min;
  double max;
};

template <class Value>
CLI::Option* add_number(CLI::App& command, const char* name, Value& value, const Range& range,
                        const std::string& help) {
  return command.add_option(name, value, help)->check(CLI::Range(range.min, range.max))->option_text("X")->group(group);
}

}  // namespace

void add_schedule_options(CLI::App& command, GenerateOptions& options) {
  const std::map<std::string, Schedule> schedules{{"fast", Schedule::Fast}, {"thesis", Schedule::Thesis}};
  CLI::Option* schedule =
      command
          .add_option("--schedule", options.schedule, "How particles are moved: fast, or thesis, pick by pick [fast]")
          ->transform(CLI::CheckedTransformer(schedules))
          ->option_text("NAME");
  ParticleOptions& particles = options.particles;
  add_choice(command, "--potential", particles.potential, potential_names, "What acts between particles (3.3)");
  add_number(command, "--decay", particles.decay, {1e-6, 100.0}, "d of the approximation 3.20 [1]");
  add_choice(command, "--neighbourhood", particles.neighbourhood, neighbourhood_names, "Who acts on whom (3.2)");
  add_number(command, "--radius", particles.radius, {1.0, 10.0}, "In unit edges, for --neighbourhood radius [1.5]");
  add_choice(command, "--force", particles.force, force_names, "5.15 or 5.16");
  add_choice(command, "--distance", particles.distance, distance_names, "5.6, 5.7 or 5.8, in forces");
  add_number(command, "--step", particles.step, {1e-6, 10.0}, "delta of 3.12 [from Newton's on the hexagonal lattice]");
  add_number(command, "--momentum", particles.momentum, {0.0, 0.99}, "beta of 3.13, 0 is first order [the schedule's]");
  add_choice(command, "--creation", particles.creation, creation_names, "Where particles are created");
  add_choice(command, "--annihilation", particles.annihilation, annihilation_names, "How particles go");
  command
      .add_flag_callback(
          "--no-virtual-triangles", [&particles] { particles.virtual_triangles = false; },
          "Without them in the creation rule (3.4.2)")
      ->group(group);
  const std::array<CLI::Option*, 4> of_thesis{
      add_number(command, "--alive-speed", particles.alive_speed, {1e-9, 0.99},
                 "Slower particles die, in unit edges per pick [0.01]"),
      add_choice(command, "--relocation", particles.relocation, relocation_names, "How particles move"),
      add_choice(command, "--picking", particles.picking, picking_names, "Who is picked (3.5)"),
      add_number(command, "--max-picks", particles.max_picks, {1.0, 1e9}, "Most picks per particle [400]")};
  for (CLI::Option* option : of_thesis) option->needs(schedule)->group("Particles of --schedule thesis");
}

}  // namespace parmesan
