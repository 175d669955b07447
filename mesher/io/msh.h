#pragma once

#include <string>
#include <string_view>

#include "mesher/io/mesh_fields.h"

namespace parmesan {

/// How the numbers of a file are written.
enum class Encoding { Text, Binary };

/// Reads a Gmsh mesh (.msh 4.1, 2.0 to 2.2; text or binary in either byte order; C. Geuzaine, J.-F. Remacle, Gmsh
/// reference manual, "MSH file format").
///
/// Triangles and lines of first order are read. Labels and regions are the first physical groups
/// of the elements, with their names; a group whose name is a whole number stands for that number (see write_msh).
/// Where no element of a dimension has a group they are the numbers of the entities, if there are several; those of
/// parts of a partitioned mesh are those of the whole.
/// Edges and triangles are ordered by their tags. Nodes that no triangle or line has are left out, but for points of a
/// geometry, which has no triangles: those of point elements in a physical group, for Gmsh writes the centres of arcs,
/// too, where there are no groups. Clockwise triangles and boundary lines with the domain to their right are turned,
/// lines that are given again are left out. NodeData and ElementData become fields, but for those called "required" of
/// 0 and 1: they mark what is required to stay, of lines and triangles in one. Of several time steps the last one
/// counts. Fields with values on a part of the nodes or triangles only are left out; notes tell of it. All z must be 0.
/// Errors: FileError with the line, or the byte of a binary file; also for elements of other kinds, fields that have
/// two values at one place, and vectors and tensors that leave the plane or are not symmetric;
/// FileValueError where a number is not finite or refers to nothing.
MeshData read_msh(const std::string& path);
MeshData parse_msh(std::string_view bytes, const std::string& name);

/// Writes Gmsh's format 4.1: each label and each region is an entity with a physical group of the same number and, if
/// it has one, its name. Gmsh numbers groups from 1: labels and regions below get a free number, and their own as name.
/// Errors: InputError when a field has not one value per entity; FileError. Cost: O(size).
void write_msh(const std::string& path, const Mesh& mesh, const MeshFields& fields = {},
               Encoding encoding = Encoding::Text);

}  // namespace parmesan
