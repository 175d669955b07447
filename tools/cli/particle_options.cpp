#include "tools/cli/particle_options.h"

#include <array>
#include <string>

#include "tools/cli/choice.h"

namespace parmesan {
namespace {

constexpr const char* group = "Particles (numbers are equations and sections of the thesis)";

template <class Value, class Names>
CLI::Option* add_name(CLI::App& command, const char* name, Value& value, const Names& names, const char* help) {
  return add_choice(command, name, value, names, help)->group(group);
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
  add_choice(command, "--schedule", options.schedule, schedule_names, "How particles are moved (thesis: pick by pick)");
  ParticleOptions& particles = options.particles;
  add_name(command, "--potential", particles.potential, potential_names, "What acts between particles (3.3)");
  add_number(command, "--decay", particles.decay, {1e-6, 100.0}, "d of the approximation 3.20 [1]");
  add_name(command, "--neighbourhood", particles.neighbourhood, neighbourhood_names, "Who acts on whom (3.2)");
  add_number(command, "--radius", particles.radius, {1.0, 10.0}, "In unit edges, for --neighbourhood radius [1.5]");
  add_name(command, "--force", particles.force, force_names, "5.15 or 5.16");
  add_name(command, "--distance", particles.distance, distance_names, "5.6, 5.7 or 5.8, in forces");
  add_number(command, "--step", particles.step, {1e-6, 10.0}, "delta of 3.12 [from Newton's on the hexagonal lattice]");
  add_number(command, "--momentum", particles.momentum, {0.0, 0.99}, "beta of 3.13, 0 is first order [the schedule's]");
  add_name(command, "--creation", particles.creation, creation_names, "Where particles are created");
  add_name(command, "--annihilation", particles.annihilation, annihilation_names, "How particles go");
  command
      .add_flag_callback(
          "--no-virtual-triangles", [&particles] { particles.virtual_triangles = false; },
          "Without them in the creation rule (3.4.2)")
      ->group(group);
  const std::array<CLI::Option*, 4> of_thesis{
      add_number(command, "--alive-speed", particles.alive_speed, {1e-9, 0.99},
                 "Slower particles die, in unit edges per pick [0.01]"),
      add_name(command, "--relocation", particles.relocation, relocation_names, "How particles move"),
      add_name(command, "--picking", particles.picking, picking_names, "Who is picked (3.5)"),
      add_number(command, "--max-picks", particles.max_picks, {1.0, 1e9}, "Most picks per particle [400]")};
  for (CLI::Option* option : of_thesis) option->group("Particles of --schedule thesis");
}

}  // namespace parmesan
