#include "mesher/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "mesher/errors.h"
#include "mesher/geometry/domain_of_mesh.h"
#include "mesher/index.h"
#include "mesher/io/boundary_edges.h"
#include "mesher/io/eps.h"
#include "mesher/io/medit.h"
#include "mesher/io/medit_fields.h"
#include "mesher/io/svg.h"
#include "mesher/io/text.h"
#include "mesher/io/triangle_files.h"
#include "mesher/io/vtu.h"

namespace parmesan {
namespace {

enum class Format { Unknown, Medit, BinaryMedit, Gmsh, Triangle, Poly, Vtu, Svg, Eps };

Format format_of(const std::string& path) {
  const std::string suffix = file_suffix(path);
  if (suffix == ".mesh") return Format::Medit;
  if (suffix == ".meshb") return Format::BinaryMedit;
  if (suffix == ".msh") return Format::Gmsh;
  if (suffix == ".node" || suffix == ".ele") return Format::Triangle;
  if (suffix == ".poly") return Format::Poly;
  if (suffix == ".vtu") return Format::Vtu;
  if (suffix == ".svg") return Format::Svg;
  if (suffix == ".eps") return Format::Eps;
  return Format::Unknown;
}

void write_fields_beside(const std::string& path, const char* suffix, const MeshFields& fields) {
  if (!fields.empty()) write_medit_fields(with_suffix(path, suffix), fields);
}

/// The fields in the file of this suffix beside the mesh; none where there is no such file.
MeshFields fields_beside(const std::string& path, const char* suffix, const Mesh& mesh) {
  const std::string fields_path = with_suffix(path, suffix);
  std::error_code ignored;
  if (!std::filesystem::exists(fields_path, ignored)) return {};
  MeshFields fields = read_medit_fields(fields_path);
  try {
    check_fields(fields, mesh);
  } catch (const InputError& error) {
    throw FileError(fields_path, 0, error.what());
  }
  return fields;
}

MeshFields medit_fields_beside(const std::string& path, const Mesh& mesh) {
  const bool is_binary = format_of(path) == Format::BinaryMedit;
  MeshFields fields = fields_beside(path, is_binary ? ".solb" : ".sol", mesh);
  return fields.empty() ? fields_beside(path, is_binary ? ".sol" : ".solb", mesh) : fields;
}

}  // namespace

bool is_written_mesh_file_name(const std::string& path) { return format_of(path) != Format::Unknown; }

void check_mesh_file_name(const std::string& path) {
  if (is_written_mesh_file_name(path)) return;
  throw FileError(path, 0, "no mesh is written to this suffix; known are " + std::string(written_suffixes));
}

void draw_with_fields(const MeshFields& fields, const WriteOptions& options,
                      const std::function<void(const PictureOptions&)>& draw) {
  PictureOptions picture = options.picture;
  const auto first = [&fields](int components) {
    return std::ranges::find(fields.points, components, &MeshField::components);
  };
  if (const auto scalars = first(1); scalars != fields.points.end()) {
    picture.values = scalars->values;
    picture.values_name = scalars->name;
  }
  std::vector<Metric> metrics;
  if (const auto tensors = first(3); options.show_metrics && tensors != fields.points.end()) {
    const std::vector<double>& v = tensors->values;
    metrics.reserve(v.size() / 3);
    for (std::size_t i = 0; i + 2 < v.size(); i += 3)
      metrics.push_back(Metric::from_tensor({v[i], v[i + 1], v[i + 2]}));
  }
  picture.metrics = metrics;
  draw(picture);
}

void write_mesh_file(const std::string& path, const Mesh& mesh, const MeshFields& fields, const WriteOptions& options) {
  check_mesh_file_name(path);
  check_fields(fields, mesh);
  switch (format_of(path)) {
    case Format::Medit:
      write_medit(path, mesh);
      return write_fields_beside(path, ".sol", fields);
    case Format::BinaryMedit:
      write_meshb(path, mesh);
      return write_fields_beside(path, ".solb", fields);
    case Format::Gmsh:
      return write_msh(path, mesh, fields, options.encoding);
    case Format::Triangle:
      return write_triangle_mesh(path, mesh);
    case Format::Poly:
      return write_poly(path, domain_of(mesh));
    case Format::Vtu:
      return write_vtu(path, mesh, fields);
    case Format::Svg:
      return draw_with_fields(fields, options, [&](const PictureOptions& picture) { write_svg(path, mesh, picture); });
    case Format::Eps:
      return draw_with_fields(fields, options, [&](const PictureOptions& picture) { write_eps(path, mesh, picture); });
    case Format::Unknown:
      break;
  }
}

namespace {

// A mesh in which only some are clockwise is wrong.
Mesh turned_if_clockwise(Mesh mesh) {
  const auto is_clockwise = [&mesh](const std::array<int, 3>& t) {
    const auto corner = [&](std::size_t k) { return mesh.points[at(t[k])]; };
    return doubled_area(corner(0), corner(1), corner(2)) < 0.0;
  };
  if (std::ranges::all_of(mesh.triangles, is_clockwise))
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace

Mesh read_mesh_file(const std::string& path) {
  switch (format_of(path)) {
    case Format::Medit:
      return turned_if_clockwise(read_medit(path));
    case Format::BinaryMedit:
      return turned_if_clockwise(read_meshb(path));
    case Format::Gmsh:
      return read_msh(path).mesh;
    case Format::Triangle:
      return turned_if_clockwise(read_triangle_mesh(path));
    default:
      throw FileError(path, 0, "no mesh is read from this suffix; known are .mesh .meshb .msh .node .ele");
  }
}

MeshData read_mesh_data(const std::string& path) {
  if (format_of(path) == Format::Gmsh) return read_msh(path);
  MeshData data{read_mesh_file(path), {}};
  if (format_of(path) != Format::Triangle) data.fields = medit_fields_beside(path, data.mesh);
  return data;
}

Mesh read_valid_mesh(const std::string& path) {
  Mesh mesh = read_mesh_file(path);
  complete(mesh);
  return mesh;
}

}  // namespace parmesan
