#pragma once

#include <string>

#include "adapt/case.h"

namespace parmesan::support {

/// A case that interpolates the function on the unit square, small and fast.
inline Case interpolation_case(const std::string& function, const std::string& targets) {
  return parse_case(R"({"name": "test", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
      "problem": {"interpolate": ")" +
                        function + R"("}, "targets": )" + targets +
                        R"(, "initial": {"vertices": 100}, "mesher": {"preset": "fast"}})",
                    "test.json");
}

/// -Laplace u = f with the exact solution given, u = exact on the boundary of the unit square.
inline Case poisson_case(const std::string& exact, const std::string& targets) {
  return parse_case(R"({"name": "test", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
      "problem": {"exact": ")" +
                        exact + R"(", "boundary": {"*": {"dirichlet": "exact"}}}, "targets": )" + targets +
                        R"(, "initial": {"vertices": 100}, "mesher": {"preset": "fast"}})",
                    "test.json");
}

/// The Poisson problem of a peak with one functional, "goal".
inline Case goal_case(const std::string& functional, const std::string& targets) {
  return parse_case(R"case({"name": "test", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
      "problem": {"exact": "exp(-50*((x - 0.5)^2 + (y - 0.5)^2))", "boundary": {"*": {"dirichlet": "exact"}}},
      "functionals": {"goal": )case" +
                        functional + R"(}, "targets": )" + targets +
                        R"(, "initial": {"vertices": 100}, "mesher": {"preset": "fast"}})",
                    "test.json");
}

}  // namespace parmesan::support
