#pragma once

#include <string>
#include <string_view>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// Reads the outline of an airfoil (.dat): a title, then x y per line.
///
/// Selig's form goes round from the trailing edge; Lednicer's (two counts after the title, then the upper and the lower
/// side, both from the leading edge) is put together to the same. The title may be missing. The domain is the inside;
/// its segments have label 1, "airfoil", and 2, "trailing_edge", for the one that closes a blunt trailing edge.
/// Errors: FileError with the line.
Domain read_airfoil(const std::string& path);
Domain parse_airfoil(std::string_view text, const std::string& name);

}  // namespace parmesan
