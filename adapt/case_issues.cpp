#include "adapt/case_issues.h"

#include <algorithm>
#include <utility>

namespace parmesan {

void CaseIssues::add(std::string pointer, std::string problem, std::optional<std::size_t> text_position) {
  const auto repeats = [&](const RawIssue& issue) { return issue.pointer == pointer && issue.problem == problem; };
  if (full() || std::any_of(issues_.begin(), issues_.end(), repeats)) return;
  issues_.push_back({std::move(pointer), std::move(problem), text_position});
}

bool CaseIssues::clean(std::string_view pointer) const {
  const auto within = [pointer](const RawIssue& issue) {
    const std::string_view at = issue.pointer;
    return at.starts_with(pointer) && (at.size() == pointer.size() || at[pointer.size()] == '/');
  };
  return !full() && std::none_of(issues_.begin(), issues_.end(), within);
}

}  // namespace parmesan
