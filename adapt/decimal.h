#pragma once

#include <string>

namespace parmesan {

/// The shortest text that reads back as the number, independent of the locale; "nan" has no sign.
std::string decimal(double value);

}  // namespace parmesan
