#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adapt/case_error.h"
#include "adapt/case_issues.h"

namespace parmesan {

/// The JSON of a case with what is needed to say where in the file something stands.
struct CaseDocument {
  std::string file;
  std::string text;
  nlohmann::ordered_json root;
  std::vector<std::string> overridden;  // JSON pointers that --set gave
};

/// The largest case file, its deepest nesting and its largest object.
inline constexpr std::size_t kMaxCaseBytes = std::size_t{64} << 20;
inline constexpr int kMaxCaseDepth = 64;
inline constexpr std::size_t kMaxCaseNames = 2000;

/// One of these limits that a text, JSON or not, exceeds. Recursive code would not survive deep nesting, and an ordered
/// object finds a name by looking at each.
struct Excess {
  std::size_t offset = 0;
  std::string problem;
};
std::optional<Excess> find_excess(const std::string& text);

/// Parses the text, notes repeated keys, and applies the overrides.
/// Errors: CaseError when the text is not JSON within the limits.
CaseDocument load_document(const std::string& text, const std::string& file, const std::vector<Override>& overrides,
                           CaseIssues& issues);

/// The issues with their lines and columns, in the order of the file.
std::vector<CaseIssue> place_issues(const CaseDocument& document, const CaseIssues& issues);

}  // namespace parmesan
