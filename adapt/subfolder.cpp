#include "adapt/subfolder.h"

#include <filesystem>
#include <system_error>

#include "mesher/errors.h"

namespace parmesan {

namespace fs = std::filesystem;

std::string make_subfolder(const std::string& folder, const std::string& name) {
  fs::path path(folder);
  for (const fs::path& part : fs::path(name)) {
    path /= part;
    std::error_code error;
    fs::create_directory(path, error);
    const fs::file_type type = fs::symlink_status(path, error).type();
    if (type == fs::file_type::directory) continue;
    if (type == fs::file_type::not_found) throw FileError(path.string(), 0, "cannot make the folder");
    throw FileError(path.string(), 0, "is a link or no folder, so nothing is written there");
  }
  return path.string();
}

}  // namespace parmesan
