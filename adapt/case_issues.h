#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parmesan {

/// Something wrong with a case, not yet located in the text.
struct RawIssue {
  std::string pointer;
  std::string problem;
  std::optional<std::size_t> text_position;  // byte within the string that stands there
};

/// Everything found wrong with a case so far, up to kMost.
class CaseIssues {
 public:
  static constexpr std::size_t kMost = 100;

  void add(std::string pointer, std::string problem, std::optional<std::size_t> text_position = std::nullopt);

  /// Nothing is wrong with this value nor with anything in it: it can be read without questions.
  /// Nothing is clean once kMost issues were found.
  bool clean(std::string_view pointer) const;

  bool full() const { return issues_.size() >= kMost; }
  bool empty() const { return issues_.empty(); }
  const std::vector<RawIssue>& all() const { return issues_; }

 private:
  std::vector<RawIssue> issues_;
};

}  // namespace parmesan
