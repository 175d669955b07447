#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "adapt/case.h"
#include "mesher/errors.h"

namespace parmesan::support {

/// A case that is right, with room for what a test wants to put in.
/// problem: the inside of "problem"; rest: further sections, each with a leading comma.
inline std::string case_text(const std::string& problem, const std::string& rest = "") {
  return R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}, "problem": {)" + problem + "}" + rest + "}";
}

inline const std::string kZeroBoundary = R"("boundary": {"*": {"dirichlet": 0}})";

/// One with this geometry.
inline std::string with_geometry(const std::string& geometry) {
  return R"({"parameters": {"r": 2}, "geometry": {)" + geometry + R"(}, "problem": {"interpolate": "x"}})";
}

inline Domain domain_of_case(const std::string& geometry) {
  return parse_case(with_geometry(geometry), "case.json").domain;
}

/// The issues that a case has, each as "pointer: problem"; empty when it is right.
inline std::vector<std::string> issues_of(const std::string& text, const std::vector<Override>& overrides = {}) {
  std::vector<std::string> issues;
  try {
    parse_case(text, "case.json", overrides);
  } catch (const CaseError& error) {
    for (const CaseIssue& issue : error.issues()) issues.push_back(issue.pointer + ": " + issue.problem);
  } catch (const GeometryError& error) {
    issues.emplace_back(error.what());
  }
  return issues;
}

/// All issues in one text, a line each.
inline std::string issue_text(const std::string& text, const std::vector<Override>& overrides = {}) {
  std::string all;
  for (const std::string& issue : issues_of(text, overrides)) all += issue + "\n";
  return all;
}

inline std::string issues_of_geometry(const std::string& geometry) { return issue_text(with_geometry(geometry)); }

}  // namespace parmesan::support
