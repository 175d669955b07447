#pragma once

#include <string>

namespace parmesan::support {

/// The unit square as a .poly file, its sides labelled 1 to 4 from below.
inline const std::string square_poly =
    "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n";

}  // namespace parmesan::support
