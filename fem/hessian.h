#pragma once

namespace parmesan {

/// Second derivatives at a vertex.
struct Hessian {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};

}  // namespace parmesan
