#include "mesher/metric/metric_field.h"

#include <locale>
#include <sstream>

#include "mesher/errors.h"

namespace parmesan {

void throw_unusable(const Point& p) {
  std::ostringstream message;
  message.imbue(std::locale::classic());
  message << "the metric at (" << p.x << ", " << p.y << ") is not finite and positive definite in double precision";
  throw InputError(message.str());
}

}  // namespace parmesan
