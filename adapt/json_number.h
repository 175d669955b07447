#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace parmesan {

/// A number as JSON; null where there is none, or one that JSON cannot say (infinite, not a number).
inline nlohmann::ordered_json json_number(const std::optional<double>& x) {
  return x && std::isfinite(*x) ? nlohmann::ordered_json(*x) : nlohmann::ordered_json(nullptr);
}

}  // namespace parmesan
