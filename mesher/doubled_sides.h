#pragma once

#include <string>
#include <vector>

#include "mesher/cracks.h"

namespace parmesan {

/// What was told by doubled vertices alone, one sentence each: parts that were joined, cracks without a label.
std::vector<std::string> notes_on_doubled_sides(const ClosedMesh& closed);

}  // namespace parmesan
