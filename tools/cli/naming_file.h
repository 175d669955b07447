#pragma once

#include <string>

#include "fem/problem.h"
#include "mesher/errors.h"

namespace parmesan {

/// What the action returns. Errors: those of the action; a GeometryError or ProblemError that does not begin with the
/// file's name gets it.
template <class Action>
auto naming_file(const std::string& file, const Action& action) {
  const auto named = [&file](const std::string& message) {
    return message.starts_with(file) ? message : file + ": " + message;
  };
  try {
    return action();
  } catch (const GeometryError& error) {
    throw GeometryError(named(error.what()), error.indices());
  } catch (const ProblemError& error) {
    throw ProblemError(named(error.what()));
  }
}

}  // namespace parmesan
