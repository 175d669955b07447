#include "mesher/mesh.h"

#include <algorithm>

namespace parmesan {

std::vector<int> ascending(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

std::string label_name(const LabelNames& names, int label) {
  const auto found = names.find(label);
  return found == names.end() ? std::to_string(label) : found->second;
}

}  // namespace parmesan
