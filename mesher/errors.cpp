#include "mesher/errors.h"

namespace parmesan {

FileError::FileError(const std::string& path, int line, const std::string& problem)
    : InputError(path + (line > 0 ? ":" + std::to_string(line) : "") + ": " + problem), path_(path), line_(line) {}

}  // namespace parmesan
