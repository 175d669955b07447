#pragma once

#include <string>
#include <vector>

#include "mesher/generate.h"

namespace parmesan {

/// An option of the mesher that has no effect beside the others.
struct IdleOption {
  std::string pointer;  // below "mesher" in a case file: "/particles/max_picks"
  std::string problem;  // what it is for
};

/// Those of the particles that are set to something else than their default but not read. A preset is not among them:
/// a case is tried with either schedule.
std::vector<IdleOption> idle_options(const GenerateOptions& options);

}  // namespace parmesan
