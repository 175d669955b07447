#pragma once

#include <string>
#include <vector>

#include "mesher/errors.h"

namespace parmesan {

/// One thing that is wrong with a case file.
struct CaseIssue {
  std::string pointer;  // JSON pointer
  int line = 0;         // 1-based, 0 when unknown
  int column = 0;
  std::string problem;  // what is wrong, what is allowed, the nearest right name
};

/// A case file cannot be used; what() lists every issue, one per line. Exit code 3.
class CaseError : public InputError {
 public:
  CaseError(const std::string& file, std::vector<CaseIssue> issues);
  const std::vector<CaseIssue>& issues() const { return issues_; }

 private:
  std::vector<CaseIssue> issues_;
};

/// A value that replaces or adds one in the case: --set /json/pointer=VALUE.
struct Override {
  std::string pointer;
  std::string value;  // JSON, or a plain string when it is not JSON
};

}  // namespace parmesan
