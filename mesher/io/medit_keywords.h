#pragma once

#include <string>

#include "mesher/io/text.h"

namespace parmesan {

/// Reads the MeshVersionFormatted with which every Medit file begins. Errors: FileError.
void read_medit_version(TextReader& in);

/// The next keyword in lower case; "end" is the last.
/// Errors: FileError when the file ends before, or something else than a keyword comes next.
std::string read_medit_keyword(TextReader& in);

/// The number after Dimension. Errors: FileError unless it is 2 or 3.
int read_medit_dimension(TextReader& in);

}  // namespace parmesan
