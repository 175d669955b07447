#pragma once

#include <string>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Whether read_geometry knows the suffix.
bool is_geometry_file_name(const std::string& path);

/// Whether a file of this suffix is a domain and never a mesh: .poly, .dat.
bool is_domain_file_name(const std::string& path);

/// Reads what is to be meshed, in the format that the suffix names.
///
/// .poly (Triangle): segments with markers as labels, holes, regions. .dat: an airfoil (see read_airfoil).
/// .mesh, .meshb (Medit), .msh (Gmsh): without triangles the edges are the segments and bound the domain by the
/// even-odd rule; with triangles the domain is that of the mesh, its boundary and labelled edges, as it is for .node
/// and .ele. Errors: FileError with the line or the byte, or naming the suffixes that are known; FileValueError where a
/// number is not finite or refers to nothing.
Domain read_geometry(const std::string& path);

/// The segments of a mesh without triangles, by the even-odd rule, or the domain of one with triangles (see domain_of),
/// whose boundary edges may be missing or have any direction. Errors: as cover_boundary.
Domain geometry_of(Mesh mesh);

}  // namespace parmesan
