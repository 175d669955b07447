#include "tools/cli/version.h"

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "adapt/math_library.h"

namespace parmesan {
namespace {

std::string number(int value) { return std::to_string(value); }

std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string build() {
#ifdef NDEBUG
  std::string text = "optimised, without assertions";
#else
  std::string text = "with assertions";
#endif
#ifdef __SANITIZE_ADDRESS__
  text += ", AddressSanitizer";
#endif
#ifdef _OPENMP
  text += ", OpenMP " + number(_OPENMP);
#else
  text += ", one thread";
#endif
  return text;
}

}  // namespace

std::string version_text() {
  return "parmesan " PARMESAN_VERSION "\n  compiler:  " + compiler() + "\n  build:     " + build() +
         "\n  libraries: Eigen " + number(EIGEN_WORLD_VERSION) + "." + number(EIGEN_MAJOR_VERSION) + "." +
         number(EIGEN_MINOR_VERSION) + ", nlohmann_json " + number(NLOHMANN_JSON_VERSION_MAJOR) + "." +
         number(NLOHMANN_JSON_VERSION_MINOR) + "." + number(NLOHMANN_JSON_VERSION_PATCH) +
         ", CLI11 " CLI11_VERSION ", " + math_library();
}

}  // namespace parmesan
