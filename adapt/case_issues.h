#pragma once

#include <algorithm>
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
  bool is_geometry = false;                  // the case can be read, but encloses no domain
};

/// Everything found wrong with a case so far, up to kMost.
class CaseIssues {
 public:
  static constexpr std::size_t kMost = 100;

  void add(std::string pointer, std::string problem, std::optional<std::size_t> text_position = std::nullopt);

  void add_geometry(std::string pointer, std::string problem);

  /// Nothing is wrong with this value nor with anything in it: it can be read without questions.
  /// Nothing is clean once kMost issues were found.
  bool clean(std::string_view pointer) const;

  bool full() const { return issues_.size() >= kMost; }
  bool empty() const { return issues_.empty(); }

  /// Is nothing else wrong than the geometry?
  bool are_geometry() const { return std::ranges::all_of(issues_, &RawIssue::is_geometry); }
  const std::vector<RawIssue>& all() const { return issues_; }

 private:
  void add(RawIssue issue);

  std::vector<RawIssue> issues_;
};

}  // namespace parmesan
