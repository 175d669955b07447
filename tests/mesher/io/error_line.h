#pragma once

#include <string>

#include "mesher/errors.h"

namespace parmesan::support {

/// The line of the FileError that f throws, -1 when it throws none.
template <class F>
int error_line(const F& f) {
  try {
    f();
  } catch (const FileError& error) {
    return error.line();
  }
  return -1;
}

/// The message of the FileError that f throws, empty when it throws none.
template <class F>
std::string error_message(const F& f) {
  try {
    f();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace parmesan::support
