#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "tools/thesis/experiment.h"

namespace {

using namespace parmesan::thesis;

// In the order of the thesis.
const std::vector<std::pair<std::string, Item (*)(const Setting&)>> experiments{
    {"evolution", evolution},        {"in_circle", in_circle_forms},
    {"table_2_1", table_2_1},        {"uniform", uniform_square},
    {"potentials", potentials},      {"gaussian", gaussian},
    {"background", background_mesh}, {"forces", forces},
    {"running_time", running_time},  {"picking_order", picking_order},
    {"remeshing", remeshing},        {"population", population},
    {"oscillation", oscillation}};

}  // namespace

// thesis_experiments FOLDER [--quick] [NAME...]: one line of JSON for each experiment; pictures go into the folder.
int main(int argc, char** argv) {
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty()) throw std::invalid_argument("usage: thesis_experiments FOLDER [--quick] [NAME...]");
    Setting setting{words[0], false};
    std::vector<std::string> names;
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (words[i] == "--quick")
        setting.quick = true;
      else
        names.push_back(words[i]);
    }
    use_threads(1);
    for (const auto& [name, experiment] : experiments) {
      if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
      const auto start = std::chrono::steady_clock::now();
      Json item = experiment(setting).json();
      item["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      std::cout << item.dump() << std::endl;
    }
    return 0;
  } catch (const std::exception& e) {
    std::cerr << "thesis_experiments: " << e.what() << std::endl;
    return 1;
  }
}
