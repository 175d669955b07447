#include "adapt/case_document.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "adapt/json_text.h"
#include "mesher/io/utf8.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& file, LineColumn at, const std::string& problem) {
  throw CaseError(file, {{"", at.line, at.column, problem}});
}

/// nlohmann's message without "[json.exception.parse_error.101] parse error at line 2, column 3: ".
std::string plain_message(const std::string& what) {
  const std::size_t bracket = what.find("] ");
  const std::string message = bracket == std::string::npos ? what : what.substr(bracket + 2);
  const std::size_t colon = message.starts_with("parse error") ? message.find(": ") : std::string::npos;
  return colon == std::string::npos ? message : message.substr(colon + 2);
}

std::string too_deep() { return "nested more than " + std::to_string(kMaxCaseDepth) + " deep"; }

Json parse_json(const std::string& text, const std::string& file) {
  const auto refuse_at = [&](std::size_t offset, const std::string& problem) {
    refuse(file, line_column(text, offset), problem);
  };
  if (const std::optional<Excess> excess = find_excess(text)) refuse_at(excess->offset, excess->problem);
  // nlohmann's parser takes a NUL for the end.
  if (const std::size_t nul = text.find('\0'); nul != std::string::npos) refuse_at(nul, "not JSON: a NUL character");
  try {
    return Json::parse(text, nullptr, true, true);
  } catch (const Json::parse_error& error) {
    refuse_at(error.byte > 0 ? error.byte - 1 : 0, "not JSON: " + plain_message(error.what()));
  } catch (const Json::exception& error) {  // a number beyond double precision
    refuse_at(find_overflow(text).value_or(0), "not JSON: " + plain_message(error.what()));
  }
  return {};
}

std::string given_twice(LineColumn second) {
  return "the key is given twice; the second time in line " + std::to_string(second.line) + ", column " +
         std::to_string(second.column);
}

/// VALUE as JSON where it is, else as the text itself.
std::optional<Json> override_value(const std::string& text) {
  if (find_excess(text)) return std::nullopt;
  try {
    return Json::parse(text, nullptr, true, true);
  } catch (const Json::exception&) {
    return Json(text);
  }
}

/// The member or element of parent, made if it can be; null if it cannot.
Json* child(Json& parent, const std::string& step) {
  if (parent.is_null()) parent = Json::object();
  if (parent.is_object()) return &parent[step];
  if (!parent.is_array()) return nullptr;
  std::size_t index = parent.size();
  const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
  const bool number = error == std::errc() && end == step.data() + step.size();
  if (step != "-" && (!number || index > parent.size())) return nullptr;
  if (index == parent.size()) parent.push_back(nullptr);
  return &parent[index];
}

void apply_override(const Override& entry, CaseDocument& document, CaseIssues& issues) {
  document.overridden.push_back(entry.pointer);
  const std::optional<std::vector<std::string>> steps = pointer_steps(entry.pointer);
  if (!steps || steps->empty()) {
    return issues.add(entry.pointer, "not a JSON pointer to set; write for example /targets/max_iterations=5");
  }
  if (!is_utf8(entry.pointer) || !is_utf8(entry.value))
    return issues.add(entry.pointer, "has bytes that are not UTF-8");
  std::optional<Json> value = override_value(entry.value);
  if (!value || steps->size() > static_cast<std::size_t>(kMaxCaseDepth))
    return issues.add(entry.pointer, value ? too_deep() : find_excess(entry.value)->problem);
  if (value->is_structured()) {
    for (const DuplicateKey& duplicate : find_duplicate_keys(entry.value, CaseIssues::kMost))
      issues.add(entry.pointer + duplicate.pointer,
                 given_twice(line_column(entry.value, duplicate.offset)) + " of the value");
  }
  Json* place = &document.root;
  for (const std::string& step : *steps) {
    place = child(*place, step);
    if (place == nullptr) return issues.add(entry.pointer, "there is nothing with this JSON pointer to set");
  }
  *place = std::move(*value);
}

bool is_overridden(const CaseDocument& document, const std::string& pointer) {
  return std::any_of(document.overridden.begin(), document.overridden.end(),
                     [&pointer](const std::string& set) { return pointer == set || pointer.starts_with(set + "/"); });
}

CaseIssue place_issue(const CaseDocument& document, const RawIssue& issue) {
  if (is_overridden(document, issue.pointer)) return {issue.pointer, 0, 0, "(from --set) " + issue.problem};
  const JsonPlace place = locate(document.text, issue.pointer);
  std::size_t offset = place.key;
  std::string problem = issue.problem;
  if (issue.text_position && place.found) {
    const std::size_t start = place.value + 1;
    const std::string_view passed = std::string_view(document.text).substr(start, *issue.text_position);
    if (passed.find('\\') == std::string_view::npos) offset = start + *issue.text_position;
    problem += " (character " + std::to_string(*issue.text_position + 1) + " of the expression)";
  }
  const LineColumn at = line_column(document.text, offset);
  return {issue.pointer, at.line, at.column, problem};
}

}  // namespace

std::optional<Excess> find_excess(const std::string& text) {
  if (text.size() > kMaxCaseBytes) return Excess{0, "larger than " + std::to_string(kMaxCaseBytes >> 20) + " MiB"};
  if (const auto offset = find_nesting_beyond(text, kMaxCaseDepth)) return Excess{*offset, too_deep()};
  if (const auto offset = find_names_beyond(text, kMaxCaseNames))
    return Excess{*offset, "an object has more than " + std::to_string(kMaxCaseNames) + " names"};
  return std::nullopt;
}

CaseDocument load_document(const std::string& text, const std::string& file, const std::vector<Override>& overrides,
                           CaseIssues& issues) {
  CaseDocument document{file, text, parse_json(text, file), {}};
  if (!document.root.is_object()) refuse(file, {1, 1}, "a case is an object { }");
  for (const DuplicateKey& duplicate : find_duplicate_keys(text, CaseIssues::kMost)) {
    issues.add(duplicate.pointer, given_twice(line_column(text, duplicate.offset)));
  }
  for (const Override& entry : overrides) apply_override(entry, document, issues);
  return document;
}

std::vector<CaseIssue> place_issues(const CaseDocument& document, const CaseIssues& issues) {
  std::vector<CaseIssue> placed;
  for (const RawIssue& issue : issues.all()) placed.push_back(place_issue(document, issue));
  std::stable_sort(placed.begin(), placed.end(), [](const CaseIssue& a, const CaseIssue& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  });
  if (issues.full()) placed.push_back({"", 0, 0, "only the first issues are shown"});
  return placed;
}

}  // namespace parmesan
