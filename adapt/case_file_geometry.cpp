#include "adapt/case_file_geometry.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace parmesan {
namespace {

namespace fs = std::filesystem;

bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// What forbids to read the file; empty when nothing does.
std::string refusal(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return "there is no such file";
  if (!fs::is_regular_file(status)) return "this is not a regular file";
  const fs::path real = fs::canonical(path, error);
  const fs::path real_folder = fs::canonical(folder, error);
  if (error || !is_below(real, real_folder)) return "a link leads out of the case's folder";
  if (fs::file_size(real, error) > kMaxNamedBytes || error) return "the file is larger than 1 GiB";
  return {};
}

/// What may be read along with a file of this name.
std::vector<fs::path> paths_beside(const fs::path& path) {
  std::vector<fs::path> paths;
  for (const char* suffix : {".node", ".ele", ".edge", ".sol", ".solb"})
    if (path.extension() != suffix) paths.push_back(fs::path(path).replace_extension(suffix));
  return paths;
}

/// The same of the links among the files that are read along with one of this name.
std::string refusal_beside(const fs::path& path, const fs::path& folder) {
  for (const fs::path& beside : paths_beside(path)) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(beside, error))) continue;
    const std::string problem = refusal(beside, folder);
    if (!problem.empty()) return beside.filename().string() + " beside it: " + problem;
  }
  return {};
}

}  // namespace

std::optional<std::string> named_file(CaseReading& reading, const std::string& name, const std::string& pointer) {
  const fs::path written(name);
  const bool climbs = std::find(written.begin(), written.end(), "..") != written.end();
  if (name.find('\0') != std::string::npos || written.is_absolute() || climbs) {
    reading.issues.add(pointer, "must name a file beside or below the case file, without '..' or a leading '/'");
    return std::nullopt;
  }
  fs::path folder = fs::path(reading.document.file).parent_path();
  if (folder.empty()) folder = ".";
  std::string problem = refusal(folder / written, folder);
  if (problem.empty()) problem = refusal_beside(folder / written, folder);
  if (!problem.empty()) {
    reading.issues.add(pointer, "cannot read '" + name.substr(0, 200) + "': " + problem);
    return std::nullopt;
  }
  const fs::path path = folder / written;
  reading.files.push_back(path.string());
  for (const fs::path& beside : paths_beside(path)) {
    std::error_code unreadable;
    if (fs::is_regular_file(beside, unreadable)) reading.files.push_back(beside.string());
  }
  return path.string();
}

std::optional<GeometryInput> read_named_geometry(CaseReading& reading, const std::string& name,
                                                 const std::string& pointer) {
  const std::optional<std::string> path = named_file(reading, name, pointer);
  if (!path) return std::nullopt;
  const double merge_tolerance = merge_tolerance_of(reading, "/geometry");
  return read_geometry_input(*path, Crossings::Refuse, merge_tolerance);
}

}  // namespace parmesan
