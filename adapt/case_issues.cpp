#include "adapt/case_issues.h"

#include <algorithm>
#include <utility>

namespace parmesan {

void CaseIssues::add(std::string pointer, std::string problem, std::optional<std::size_t> text_position) {
  add({std::move(pointer), std::move(problem), text_position});
}

void CaseIssues::add_geometry(std::string pointer, std::string problem) {
  add({std::move(pointer), std::move(problem), std::nullopt, true});
}

void CaseIssues::add(RawIssue issue) {
  const auto repeats = [&](const RawIssue& other) {
    return other.pointer == issue.pointer && other.problem == issue.problem;
  };
  if (full() || std::any_of(issues_.begin(), issues_.end(), repeats)) return;
  issues_.push_back(std::move(issue));
}

bool CaseIssues::clean(std::string_view pointer) const {
  const auto within = [pointer](const RawIssue& issue) {
    const std::string_view at = issue.pointer;
    return at.starts_with(pointer) && (at.size() == pointer.size() || at[pointer.size()] == '/');
  };
  return !full() && std::none_of(issues_.begin(), issues_.end(), within);
}

}  // namespace parmesan
