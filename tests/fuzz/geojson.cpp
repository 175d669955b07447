#include <cstddef>
#include <cstdint>
#include <string>

#include "adapt/io/geojson.h"
#include "mesher/errors.h"

/// Any bytes are the polygons of a GeoJSON text, or an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const parmesan::Domain domain = parmesan::parse_geojson(text, "fuzz.geojson");
    for (const parmesan::Segment& segment : domain.segments) {
      for (const int point : {segment.a, segment.b}) {
        if (point < 0 || point >= static_cast<int>(domain.points.size())) __builtin_trap();
      }
    }
  } catch (const parmesan::InputError&) {
  }
  return 0;
}
