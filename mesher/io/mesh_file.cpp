#include "mesher/io/mesh_file.h"

#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "mesher/io/svg.h"
#include "mesher/io/text.h"
#include "mesher/io/triangle_files.h"
#include "mesher/io/vtu.h"

namespace parmesan {
namespace {

enum class Format { Unknown, Medit, Vtu, Svg, Triangle };

Format format_of(const std::string& path) {
  const std::string suffix = file_suffix(path);
  if (suffix == ".mesh") return Format::Medit;
  if (suffix == ".vtu") return Format::Vtu;
  if (suffix == ".svg") return Format::Svg;
  if (suffix == ".node" || suffix == ".ele") return Format::Triangle;
  return Format::Unknown;
}

}  // namespace

void check_mesh_file_name(const std::string& path) {
  if (format_of(path) != Format::Unknown) return;
  throw FileError(path, 0, "no mesh is written to this suffix; known are .mesh .vtu .svg .node .ele");
}

void write_mesh_file(const std::string& path, const Mesh& mesh) {
  check_mesh_file_name(path);
  switch (format_of(path)) {
    case Format::Medit:
      return write_medit(path, mesh);
    case Format::Vtu:
      return write_vtu(path, mesh);
    case Format::Svg:
      return write_svg(path, mesh);
    case Format::Triangle:
      return write_triangle_mesh(path, mesh);
    case Format::Unknown:
      break;
  }
}

Mesh read_mesh_file(const std::string& path) {
  const Format format = format_of(path);
  if (format == Format::Medit) return read_medit(path);
  if (format == Format::Triangle) return read_triangle_mesh(path);
  throw FileError(path, 0, "no mesh is read from this suffix; known are .mesh .node .ele");
}

}  // namespace parmesan
