#pragma once

#include <string>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// Reads what is to be meshed from any file that is understood: those of read_geometry, and GeoJSON (.geojson, .json).
/// Errors: as read_geometry and read_geojson.
Domain read_any_geometry(const std::string& path);

/// Whether a file of this suffix is a domain and never a mesh.
bool is_any_domain_file_name(const std::string& path);

}  // namespace parmesan
