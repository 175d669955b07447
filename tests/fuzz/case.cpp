#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "adapt/case.h"
#include "mesher/errors.h"
#include "tests/fuzz/check.h"

namespace {

using Json = nlohmann::ordered_json;

/// Whether a shape is asked for with so many points that the fuzzer would wait for them.
bool asks_for_much(const std::string& text) {
  constexpr double much = 100.0;
  bool is_count = false, found = false;
  const auto watch = [&](int depth, Json::parse_event_t event, const Json& value) {
    using Event = Json::parse_event_t;
    if (event == Event::value) found = found || (is_count && value.is_number() && !(value.get<double>() <= much));
    if (event == Event::key) is_count = value == "points";
    found = found || depth > 64;
    return !found;
  };
  (void)Json::parse(text, watch, false, true);
  return found;
}

}  // namespace

/// Any bytes are a case, whose resolved form is the same case, or an InputError; a CaseError has issues with places.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (asks_for_much(text)) return 0;
  try {
    const std::string resolved = parmesan::parse_case(text, "fuzz.json").resolved.dump();
    CHECK(parmesan::parse_case(resolved, "fuzz.json").resolved.dump() == resolved);
  } catch (const parmesan::CaseError& error) {
    CHECK(!error.issues().empty());
    for (const parmesan::CaseIssue& issue : error.issues()) CHECK(issue.line >= 1 && issue.column >= 1);
  } catch (const parmesan::InputError&) {
  }
  return 0;
}
