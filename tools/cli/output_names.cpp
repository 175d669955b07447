#include "tools/cli/output_names.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "mesher/io/text.h"

namespace parmesan {
namespace {

std::vector<std::string> files_of(const std::string& name) {
  const std::string suffix = file_suffix(name);
  if (suffix != ".node" && suffix != ".ele") return {name};
  return {with_suffix(name, ".node"), with_suffix(name, ".ele"), with_suffix(name, ".edge")};
}

bool are_same(const std::string& one, const std::string& other) {
  std::error_code error;
  if (std::filesystem::equivalent(one, other, error)) return true;
  const auto place = [&error](const std::string& name) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(name, error), error);
  };
  return place(one) == place(other);
}

bool share_a_file(const std::string& one, const std::string& other) {
  const std::vector<std::string> others = files_of(other);
  return std::ranges::any_of(files_of(one), [&others](const std::string& file) {
    return std::ranges::any_of(others, [&file](const std::string& each) { return are_same(file, each); });
  });
}

}  // namespace

std::string clash_of_names(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    const auto is_this = [&](const std::string& other) { return !other.empty() && share_a_file(*output, other); };
    if (std::any_of(inputs.begin(), inputs.end(), is_this)) return *output + " is read and would be written over";
    if (std::any_of(outputs.begin(), output, is_this)) return *output + " is named twice as an output";
  }
  return "";
}

}  // namespace parmesan
