#include "tools/cli/exit_code.h"

#include <exception>
#include <iostream>
#include <new>

#include "adapt/case.h"
#include "fem/problem.h"
#include "mesher/errors.h"
#include "tools/cli/escape.h"

namespace parmesan {
void print_error(const std::string& message) {
  std::cerr << "parmesan: error: " << escape_control(message, true) << std::endl;
}

void print_warning(const std::string& message) {
  std::cerr << "parmesan: warning: " << escape_control(message, true) << std::endl;
}

ExitCode report_current_exception() {
  const auto fail = [](ExitCode code, const std::string& message) {
    print_error(message);
    return code;
  };
  try {
    throw;
  } catch (const GeometryError& e) {
    return fail(ExitCode::BadGeometry, e.what());
  } catch (const FileValueError& e) {
    return fail(ExitCode::BadCase, e.what());
  } catch (const FileError& e) {
    return fail(ExitCode::FileProblem, e.what());
  } catch (const LimitError& e) {
    return fail(ExitCode::LimitHit, e.what());
  } catch (const InputError& e) {  // CaseError, ProblemError and the like
    return fail(ExitCode::BadCase, e.what());
  } catch (const MeshingError& e) {
    return fail(ExitCode::NoMesh, e.what());
  } catch (const SolveError& e) {
    return fail(ExitCode::NoSolution, e.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::LimitHit, "not enough memory; ask for fewer vertices, or see --limit memory_mb");
  } catch (const std::exception& e) {
    return fail(ExitCode::Bug, std::string(e.what()) + "\nthis is a bug in parmesan");
  } catch (...) {
    return fail(ExitCode::Bug, "unknown exception\nthis is a bug in parmesan");
  }
}

}  // namespace parmesan
