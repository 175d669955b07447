#include "mesher/metric/metric_field.h"

#include "mesher/errors.h"
#include "mesher/number_text.h"

namespace parmesan {

void throw_unusable(const Point& p) {
  throw InputError("the metric at " + text(p, 6) + " is not finite and positive definite in double precision");
}

}  // namespace parmesan
