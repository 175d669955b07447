#pragma once

#include <string>
#include <vector>

#include "mesher/generate.h"

namespace parmesan {

/// An option of the mesher that has no effect beside the others.
struct IdleOption {
  std::string pointer;  // below "mesher" in a case file: "/preset", "/particles/max_picks"
  std::string problem;  // what it is for
};

/// Those that are set to something else than their default but not read.
std::vector<IdleOption> idle_options(const GenerateOptions& options);

}  // namespace parmesan
