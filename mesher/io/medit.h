#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// Reads a Medit mesh (ASCII .mesh; P. Frey, MEDIT, INRIA RT-0253, 2001).
///
/// Vertices, Edges and Triangles are read with the references of the last two as labels and
/// regions; those of vertices and other keywords are skipped. The keywords may come in any order, Edges and Triangles
/// several times, but the first must be MeshVersionFormatted and the last End: a file without it counts as cut off. In
/// dimension 3 all z must be 0. Triangles keep the orientation that they have in the file. Errors: FileError with the
/// line, also for Quadrilaterals and solids; FileValueError where a number is not finite or refers to nothing. Cost:
/// O(size); 0.3 s for a million vertices with their triangles.
Mesh read_medit(const std::string& path);

/// The same from a text; name is what messages call it.
Mesh parse_medit(std::string_view text, const std::string& name);

/// Writes points, edges with labels and triangles with regions so that they read back bit by bit.
/// Names of labels and regions have no place in the format; the references of vertices are 0. Errors: FileError.
void write_medit(const std::string& path, const Mesh& mesh);

/// Reads a binary Medit mesh (.meshb, versions 1 to 4, either byte order) as read_medit reads its text.
/// Errors: as read_medit, with the byte. Cost: O(size); 0.1 s of CPU to read and write a million vertices with their
/// triangles.
Mesh read_meshb(const std::string& path);
Mesh parse_meshb(std::string_view bytes, const std::string& name);

/// Writes what write_medit writes in binary, with reals of 64 bits. Errors: FileError.
void write_meshb(const std::string& path, const Mesh& mesh);

/// Reads a metric at the vertices of a mesh from a Medit .sol or .solb file with one field: a symmetric
/// tensor m11 m12 m22 (type 3) or a size h (type 1), which gives the isotropic metric h^-2 I.
///
/// Units: m in L^-2, h in L. expected_count: the number of vertices, checked where given.
/// Errors: FileError with the line or the byte; FileValueError where a number is not finite or a tensor not positive
/// definite.
std::vector<Metric> read_medit_metric(const std::string& path, std::optional<int> expected_count = std::nullopt);
std::vector<Metric> parse_medit_metric(std::string_view text, const std::string& name,
                                       std::optional<int> expected_count = std::nullopt);

/// Reads one symmetric tensor m11 m12 m22 per vertex (type 3), definite or not, from .sol or .solb.
/// Errors: FileError with the line or the byte; FileValueError where a number is not finite.
std::vector<SymmetricTensor> read_medit_tensor(const std::string& path,
                                               std::optional<int> expected_count = std::nullopt);

/// Writes m11 m12 m22 per vertex (type 3). Errors: FileError.
void write_medit_metric(const std::string& path, std::span<const Metric> metrics);

}  // namespace parmesan
