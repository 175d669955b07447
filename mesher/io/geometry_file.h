#pragma once

#include <string>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// Reads what is to be meshed, in the format that the suffix names.
///
/// .poly (Triangle): segments with markers as labels, holes, regions. .mesh (Medit): without
/// triangles its edges are the segments and bound the domain by the even-odd rule; with triangles
/// the domain is that of the mesh, its boundary and labelled edges, as it is for .node and .ele.
/// Errors: FileError with the line, or naming the suffixes that are known.
Domain read_geometry(const std::string& path);

}  // namespace parmesan
