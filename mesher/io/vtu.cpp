#include "mesher/io/vtu.h"

#include <bit>
#include <cstdint>

#include "mesher/io/base64.h"
#include "mesher/io/output_file.h"
#include "mesher/io/xml_text.h"

namespace parmesan {
namespace {

constexpr const char* byte_order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

/// One array as <DataArray>: its size in bytes (64 bits), then its bytes, in base64.
template <class Number>
void write_array(OutputFile& out, const char* type, const std::string& name, int components,
                 const std::vector<Number>& values) {
  out << "<DataArray type=\"" << type << "\" Name=\"" << xml_escaped(name) << '"';
  if (components != 1) out << " NumberOfComponents=\"" << components << '"';
  out << " format=\"binary\">";
  const std::uint64_t bytes = values.size() * sizeof(Number);
  Base64Writer encoded(out);
  encoded.write(&bytes, sizeof(bytes));
  encoded.write(values.data(), bytes);
  encoded.finish();
  out << "</DataArray>\n";
}

void write_points(OutputFile& out, const Mesh& mesh) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * mesh.points.size());
  for (const Point& point : mesh.points) coordinates.insert(coordinates.end(), {point.x, point.y, 0.0});
  out << "<Points>\n";
  write_array(out, "Float64", "Points", 3, coordinates);
  out << "</Points>\n";
}

void write_cells(OutputFile& out, const Mesh& mesh) {
  constexpr std::uint8_t vtk_triangle = 5;
  std::vector<std::int32_t> connectivity;
  std::vector<std::int64_t> offsets;
  connectivity.reserve(3 * mesh.triangles.size());
  offsets.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    connectivity.insert(connectivity.end(), triangle.begin(), triangle.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  out << "<Cells>\n";
  write_array(out, "Int32", "connectivity", 1, connectivity);
  write_array(out, "Int64", "offsets", 1, offsets);
  write_array(out, "UInt8", "types", 1, std::vector<std::uint8_t>(mesh.triangles.size(), vtk_triangle));
  out << "</Cells>\n";
}

/// ParaView knows scalars, vectors and tensors by their 1, 3 and 9 components.
void write_field(OutputFile& out, const MeshField& field) {
  write_array(out, "Float64", field.name, components_in_space(field), values_in_space(field));
}

void write_required(OutputFile& out, const std::vector<int>& required, std::size_t n) {
  if (!required.empty()) write_array(out, "UInt8", kRequiredField, 1, required_marks(required, n));
}

void write_fields(OutputFile& out, const Mesh& mesh, const MeshFields& fields) {
  out << "<PointData>\n";
  write_required(out, mesh.required.vertices, mesh.points.size());
  for (const MeshField& field : fields.points) write_field(out, field);
  out << "</PointData>\n<CellData>\n";
  write_array(out, "Int32", "region", 1, mesh.regions);
  write_required(out, mesh.required.triangles, mesh.triangles.size());
  for (const MeshField& field : fields.cells) write_field(out, field);
  out << "</CellData>\n";
}

}  // namespace

void write_vtu(const std::string& path, const Mesh& mesh, const MeshFields& fields) {
  check_fields(fields, mesh);
  OutputFile out(path);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"" << byte_order
      << "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << mesh.points.size()
      << "\" NumberOfCells=\"" << mesh.triangles.size() << "\">\n";
  write_points(out, mesh);
  write_cells(out, mesh);
  write_fields(out, mesh, fields);
  out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  out.commit();
}

void write_pvd(const std::string& path, std::span<const PvdEntry> entries) {
  OutputFile out(path);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"" << byte_order
      << "\">\n<Collection>\n";
  for (const PvdEntry& entry : entries) {
    out << "<DataSet timestep=\"" << entry.time << "\" part=\"0\" file=\"" << xml_escaped(entry.file) << "\"/>\n";
  }
  out << "</Collection>\n</VTKFile>\n";
  out.commit();
}

}  // namespace parmesan
