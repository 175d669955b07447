#pragma once

#include <string>
#include <string_view>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Reads a .poly file of Triangle (J. R. Shewchuk, 1996, www.cs.cmu.edu/~quake/triangle.poly.html).
///
/// Vertices are numbered from 0 or from 1; where their count is 0 they are in the .node file beside
/// it. Segment markers become labels, 0 where there is none; attributes and markers of vertices and
/// area limits are skipped; the attribute of a region is its number. The lists of holes and of
/// regions may be missing, so a file that is cut off between these lists goes unnoticed.
/// Errors: FileError with the line.
Domain read_poly(const std::string& path);

/// The same from a text that has its vertices within; name is what messages call it.
Domain parse_poly(std::string_view text, const std::string& name);

/// Throws FileError for a domain with cracks, which .poly cannot express.
void check_without_cracks(const std::string& path, const Domain& domain);

/// Errors: FileError, also for what .poly cannot express: a domain by the even-odd rule, curves, cracks.
void write_poly(const std::string& path, const Domain& domain);

/// Reads PATH.node, PATH.ele and, where there is one, PATH.edge, for a path with any suffix. A .node without an .ele
/// beside it is points alone.
///
/// Of the edges those are taken that have a marker or lie on the boundary; boundary edges are
/// turned to have the triangle to their left. Triangles with one attribute have it as region.
/// Errors: FileError with the line.
Mesh read_triangle_mesh(const std::string& path);

/// The same from the three texts; an empty edge_text stands for no .edge file. stem: the path without suffix, for
/// messages.
Mesh parse_triangle_mesh(std::string_view node_text, std::string_view ele_text, std::string_view edge_text,
                         const std::string& stem);

/// Writes the three files, numbered from 1, so that they read back bit by bit, except for interior
/// edges with label 0, which Triangle takes for unmarked ones. Errors: FileError.
void write_triangle_mesh(const std::string& path, const Mesh& mesh);

}  // namespace parmesan
