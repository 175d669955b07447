#pragma once

#include <string>

#include "fem/problem.h"
#include "mesher/errors.h"

namespace parmesan {

/// A message with the file's name before it, unless it begins so or there is none.
inline std::string named(const std::string& file, const std::string& message) {
  return file.empty() || message.starts_with(file) ? message : file + ": " + message;
}

/// What the action returns. Errors: those of the action; a GeometryError or ProblemError that does not begin with the
/// file's name gets it.
template <class Action>
auto naming_file(const std::string& file, const Action& action) {
  try {
    return action();
  } catch (const GeometryError& error) {
    throw GeometryError(named(file, error.what()), error.indices());
  } catch (const ProblemError& error) {
    throw ProblemError(named(file, error.what()));
  }
}

}  // namespace parmesan
