#include "adapt/io/any_mesh.h"

#include "adapt/io/png.h"
#include "mesher/errors.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

bool is_png(const std::string& path) { return file_suffix(path) == ".png"; }

}  // namespace

void check_any_mesh_name(const std::string& path) {
  if (is_png(path) || is_written_mesh_file_name(path)) return;
  throw FileError(path, 0, "no mesh is written to this suffix; known are " + std::string(written_suffixes) + " .png");
}

void write_any_mesh(const std::string& path, const Mesh& mesh, const MeshFields& fields, const WriteOptions& options) {
  if (!is_png(path)) return write_mesh_file(path, mesh, fields, options);
  check_fields(fields, mesh);
  draw_with_fields(fields, options, [&](const PictureOptions& picture) { write_png(path, mesh, picture); });
}

}  // namespace parmesan
