#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "mesher/particles/particle_options.h"

namespace parmesan {

/// "'godo' is none of 'fast', 'mid', 'good'; did you mean 'good'?"
std::string none_of(const std::string& word, std::span<const std::string> allowed);

/// What a word stands for in the value of an option. Errors: CLI::ValidationError unless it is one of the names.
template <class T, std::size_t N>
T choose(const std::string& option, const std::string& word, const std::array<OptionName<T>, N>& names) {
  std::vector<std::string> allowed;
  for (const auto& [name, meaning] : names) {
    if (name == word) return meaning;
    allowed.emplace_back(name);
  }
  throw CLI::ValidationError(option, none_of(word, allowed));
}

/// Adds an option whose value is one of the names, which its help lists with the default. value, a T or an optional one
/// where the schedule has its own, must outlive the command.
template <class Value, class T, std::size_t N>
CLI::Option* add_choice(CLI::App& command, const std::string& option, Value& value,
                        const std::array<OptionName<T>, N>& names, const std::string& help) {
  std::string list;
  std::string usual = "the schedule's";
  for (const auto& [name, meaning] : names) {
    list += (list.empty() ? "" : ", ") + std::string(name);
    if (value == meaning) usual = name;
  }
  const auto set = [&value, option, names](const std::string& word) { value = choose(option, word, names); };
  return command.add_option_function<std::string>(option, set, help + ": " + list + " [" + usual + "]")
      ->option_text("NAME");
}

}  // namespace parmesan
