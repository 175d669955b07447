#pragma once

#include <string>

#include "fem/problem.h"
#include "mesher/errors.h"

namespace parmesan {

/// A message with the file's name before it, unless it begins so or there is none.
inline std::string named(const std::string& file, const std::string& message) {
  return file.empty() || message.starts_with(file) ? message : file + ": " + message;
}

/// What the action returns. Errors: those of the action, with the file's name before a message that does not begin so;
/// a FileError has its own.
template <class Action>
auto naming_file(const std::string& file, const Action& action) {
  try {
    return action();
  } catch (const FileError&) {
    throw;
  } catch (const GeometryError& error) {
    throw GeometryError(named(file, error.what()), error.indices());
  } catch (const LimitError& error) {
    throw LimitError(named(file, error.what()));
  } catch (const InputError& error) {
    throw InputError(named(file, error.what()));
  } catch (const MeshingError& error) {
    throw MeshingError(named(file, error.what()));
  } catch (const SolveError& error) {
    throw SolveError(named(file, error.what()));
  }
}

}  // namespace parmesan
