#include <cstddef>
#include <cstdint>
#include <string>

#include "adapt/io/geojson.h"
#include "mesher/errors.h"
#include "tests/fuzz/check.h"

/// Any bytes are the polygons of a GeoJSON text, or an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    CHECK(parmesan::fuzz::has_right_indices(parmesan::parse_geojson(text, "fuzz.geojson")));
  } catch (const parmesan::InputError&) {
  }
  return 0;
}
