#include "tools/cli/choice.h"

#include "adapt/nearest_name.h"

namespace parmesan {

std::string none_of(const std::string& word, std::span<const std::string> allowed) {
  return "'" + word.substr(0, 60) + "' is none of " + quoted_list(allowed) + suggestion(word, allowed);
}

}  // namespace parmesan
