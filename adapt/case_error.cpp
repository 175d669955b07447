#include "adapt/case_error.h"

#include <utility>

namespace parmesan {

namespace {

/// Control characters of names in the file must not reach a terminal.
std::string printable(const std::string& text) {
  std::string result = text;
  for (char& c : result) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 32 || code == 127) c = '?';
  }
  return result;
}

std::string describe(const std::string& file, const std::vector<CaseIssue>& issues) {
  std::string text;
  for (const CaseIssue& issue : issues) {
    if (!text.empty()) text += '\n';
    text += printable(file);
    if (issue.line > 0) text += ":" + std::to_string(issue.line) + ":" + std::to_string(issue.column);
    text += ": ";
    if (!issue.pointer.empty()) text += printable(issue.pointer) + ": ";
    text += printable(issue.problem);
  }
  return text;
}

}  // namespace

CaseError::CaseError(const std::string& file, std::vector<CaseIssue> issues)
    : InputError(describe(file, issues)), issues_(std::move(issues)) {}

}  // namespace parmesan
