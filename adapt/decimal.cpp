#include "adapt/decimal.h"

#include <cmath>

#include "mesher/geometry/message_text.h"

namespace parmesan {

std::string decimal(double value) { return std::isnan(value) ? "nan" : text(value); }

}  // namespace parmesan
