#pragma once

#include <string>

namespace parmesan {

/// FOLDER/NAME, made where it is not there; NAME may be several, as in "iterations/001". What is written into it stays
/// below FOLDER, whatever somebody has put there before.
/// Errors: FileError when a part of NAME is a link or no folder, or cannot be made.
std::string make_subfolder(const std::string& folder, const std::string& name);

}  // namespace parmesan
