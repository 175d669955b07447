#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// A named field at points or cells.
struct VtuField {
  std::string name;
  int components = 1;          // 1 scalar, 3 vector, 9 tensor by rows
  std::vector<double> values;  // components x number of points or cells, one entity after the other
};

/// A symmetric tensor in the plane per entity, as a 3 x 3 one with zeros; ParaView knows it by its size.
VtuField tensor_field(const std::string& name, std::span<const Metric> metrics);

/// Fields of a mesh at its vertices and triangles.
struct VtuFields {
  std::vector<VtuField> points;
  std::vector<VtuField> cells;
};

/// Writes the triangles for ParaView (VTK XML unstructured grid, binary data in base64), with the
/// regions as cell field "region". Errors: InputError when a field has not one value per entity,
/// FileError. Cost: O(size).
void write_vtu(const std::string& path, const Mesh& mesh, const VtuFields& fields = {});

/// One mesh of a series.
struct PvdEntry {
  double time = 0.0;  // what ParaView calls the time: for us the iteration
  std::string file;   // relative to the .pvd file
};

/// Writes a list of .vtu files that ParaView opens as one series. Errors: FileError.
void write_pvd(const std::string& path, std::span<const PvdEntry> entries);

}  // namespace parmesan
