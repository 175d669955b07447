#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "adapt/case.h"
#include "adapt/case_issues.h"

namespace parmesan {

/// The JSON of a case with what is needed to say where in the file something stands.
struct CaseDocument {
  std::string file;
  std::string text;
  nlohmann::ordered_json root;
  std::vector<std::string> overridden;  // JSON pointers that --set gave
};

/// The largest case file and its deepest nesting.
inline constexpr std::size_t kMaxCaseBytes = std::size_t{64} << 20;
inline constexpr int kMaxCaseDepth = 64;

/// Parses the text, notes repeated keys, and applies the overrides.
/// Errors: CaseError when the text is not JSON within the limits.
CaseDocument load_document(const std::string& text, const std::string& file, const std::vector<Override>& overrides,
                           CaseIssues& issues);

/// The issues with their lines and columns, in the order of the file.
std::vector<CaseIssue> place_issues(const CaseDocument& document, const CaseIssues& issues);

}  // namespace parmesan
