#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "adapt/case_reading.h"
#include "adapt/io/any_geometry.h"

namespace parmesan {

/// The largest file a case may name.
inline constexpr std::uintmax_t kMaxNamedBytes = std::uintmax_t{1} << 30;

/// The path of a file that a case names at pointer.
///
/// Only regular files beside or below the case file may be read; links must not lead elsewhere.
/// Nothing, and an issue, for any other. It becomes one of the files of the reading, with those beside it.
std::optional<std::string> named_file(CaseReading& reading, const std::string& name, const std::string& pointer);

/// Reads the geometry file that a case names at pointer, by the merge tolerance of the case's geometry.
/// Nothing, and an issue, as named_file. Errors: FileError, GeometryError for what is in it.
std::optional<GeometryInput> read_named_geometry(CaseReading& reading, const std::string& name,
                                                 const std::string& pointer);

}  // namespace parmesan
