#pragma once

#include <optional>
#include <string>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// A geometry, and the mesh that it is the domain of: a file may be one whose triangles are required to stay.
struct GeometryInput {
  Domain domain;
  std::optional<Mesh> mesh;  // with triangles, one that can be computed on
};

/// Reads what is to be meshed from any file that is understood: those of read_geometry, and GeoJSON (.geojson, .json).
/// crossings: of features that have to be told apart (GeoJSON); others are left to clean(). merge_tolerance: the
/// domain's, unless features had to be told apart, whose rings are merged by it at once. Errors: as read_geometry,
/// read_geojson and read_valid_mesh.
GeometryInput read_geometry_input(const std::string& path, Crossings crossings = Crossings::Refuse,
                                  double merge_tolerance = 0.0);

/// Whether a file of this suffix is a domain and never a mesh.
bool is_any_domain_file_name(const std::string& path);

}  // namespace parmesan
