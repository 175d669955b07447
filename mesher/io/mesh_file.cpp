#include "mesher/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <ctime>
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
#include "mesher/mesh_sides.h"

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

bool has_fields_beside(Format format) { return format == Format::Medit || format == Format::BinaryMedit; }

/// The suffixes of the files that may hold a Medit mesh's fields, in the order in which they are looked for.
std::array<const char*, 2> suffixes_of_fields(Format format) {
  if (format == Format::BinaryMedit) return {".solb", ".sol"};
  return {".sol", ".solb"};
}

/// To the second, in UTC.
std::string time_text(std::filesystem::file_time_type time) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(std::chrono::file_clock::to_sys(time));
  const std::time_t count = seconds.time_since_epoch().count();
  std::tm parts{};
  gmtime_r(&count, &parts);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &parts);
  return text.data();
}

/// A sentence where fields are older than the mesh beside them, by whole seconds; empty: they are not.
std::string note_of_age(const std::string& fields_path, const std::string& mesh_path) {
  std::error_code error, other_error;
  const auto of_fields = std::filesystem::last_write_time(fields_path, error);
  const auto of_mesh = std::filesystem::last_write_time(mesh_path, other_error);
  if (error || other_error || of_mesh - of_fields < std::chrono::seconds(1)) return {};
  return fields_path + ", of " + time_text(of_fields) + ", is older than " + mesh_path + ", of " + time_text(of_mesh) +
         ": its fields may be those of an earlier mesh";
}

/// Adds the fields in the file of this suffix beside the mesh; none where there is no such file.
void add_fields_beside(const std::string& path, const char* suffix, MeshData& data) {
  const std::string fields_path = with_suffix(path, suffix);
  std::error_code ignored;
  if (!std::filesystem::exists(fields_path, ignored)) return;
  data.fields = read_medit_fields(fields_path);
  const std::string age = note_of_age(fields_path, path);
  try {
    check_fields(data.fields, data.mesh);
  } catch (const InputError& error) {
    throw FileError(fields_path, 0, error.what() + (age.empty() ? "" : "; " + age));
  }
  if (!age.empty()) data.notes.push_back(age);
}

}  // namespace

bool is_written_mesh_file_name(const std::string& path) { return format_of(path) != Format::Unknown; }

void check_mesh_file_name(const std::string& path) {
  if (is_written_mesh_file_name(path)) return;
  throw FileError(path, 0, "no mesh is written to this suffix; known are " + std::string(written_suffixes));
}

namespace {

/// Errors: InputError with the name of the field and the vertex, counted from 1 as files do.
std::vector<Metric> metrics_of(const MeshField& tensors) {
  const std::vector<double>& v = tensors.values;
  std::vector<Metric> metrics;
  metrics.reserve(v.size() / 3);
  for (std::size_t i = 0; i + 2 < v.size(); i += 3) {
    try {
      metrics.push_back(Metric::from_tensor({v[i], v[i + 1], v[i + 2]}));
    } catch (const InputError& error) {
      throw InputError("field '" + tensors.name + "' at vertex " + std::to_string(i / 3 + 1) + ": " + error.what());
    }
  }
  return metrics;
}

}  // namespace

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
    metrics = metrics_of(*tensors);
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
  if (!has_fields_beside(format_of(path))) return data;
  for (const char* suffix : suffixes_of_fields(format_of(path)))
    if (data.fields.empty()) add_fields_beside(path, suffix, data);
  return data;
}

namespace {

std::vector<std::string> notes_on_medit(const std::string& path, const MeshFields& fields) {
  if (!fields.empty()) return {};
  for (const char* suffix : suffixes_of_fields(format_of(path))) {
    std::error_code ignored;
    const std::string fields_path = with_suffix(path, suffix);
    if (std::filesystem::exists(fields_path, ignored))
      return {fields_path + " is there from before; whoever reads " + path +
              ", which has no fields, takes those in it for its own: remove it"};
  }
  return {};
}

int num_unlabelled_inner_edges(const Mesh& mesh) {
  if (std::ranges::find(mesh.labels, 0) == mesh.labels.end()) return 0;
  std::atomic<int> count = 0;
  for_each_side(mesh, [&](const MeshSide& side) {
    if (side.edge >= 0 && !side.is_boundary() && mesh.labels[at(side.edge)] == 0) ++count;
  });
  return count;
}

std::vector<std::string> notes_on_triangle(const std::string& path, const Mesh& mesh, const MeshFields& fields) {
  std::vector<std::string> notes;
  if (!fields.empty()) notes.push_back(path + ": Triangle's files hold no fields; those of the mesh are left out");
  if (const int count = num_unlabelled_inner_edges(mesh); count > 0)
    notes.push_back(path + ": " + std::to_string(count) +
                    (count == 1 ? " edge inside of the mesh has" : " edges inside of the mesh have") +
                    " label 0, which readers of Triangle's files take for no edge");
  return notes;
}

}  // namespace

std::vector<std::string> notes_on_written(const std::string& path, const Mesh& mesh, const MeshFields& fields) {
  if (has_fields_beside(format_of(path))) return notes_on_medit(path, fields);
  if (format_of(path) == Format::Triangle) return notes_on_triangle(path, mesh, fields);
  return {};
}

Mesh read_valid_mesh(const std::string& path) {
  Mesh mesh = read_mesh_file(path);
  complete(mesh);
  return mesh;
}

}  // namespace parmesan
