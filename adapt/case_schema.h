#pragma once

#include <nlohmann/json.hpp>

namespace parmesan {

/// JSON Schema (draft 2020-12) of case files.
nlohmann::ordered_json case_schema();

}  // namespace parmesan
