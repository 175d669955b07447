#pragma once

#include <span>
#include <string>

#include "mesher/io/mesh_fields.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Writes the triangles for ParaView (VTK XML unstructured grid, binary data in base64), with the
/// regions as cell field "region" and, where there are any, the required vertices and triangles as fields "required" of
/// 0 and 1 (edges are not in these files). Errors: InputError when a field has not one value per entity,
/// FileError. Cost: O(size).
void write_vtu(const std::string& path, const Mesh& mesh, const MeshFields& fields = {});

/// One mesh of a series.
struct PvdEntry {
  double time = 0.0;  // what ParaView calls the time: for us the iteration
  std::string file;   // relative to the .pvd file
};

/// Writes a list of .vtu files that ParaView opens as one series. Errors: FileError.
void write_pvd(const std::string& path, std::span<const PvdEntry> entries);

}  // namespace parmesan
