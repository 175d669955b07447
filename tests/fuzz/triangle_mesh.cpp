#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/triangle_files.h"
#include "tests/fuzz/check.h"

/// Any bytes, cut in three at the first two NULs, are a .node, an .ele and an .edge file, or a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  const auto next = [&rest] {
    const std::string_view part = rest.substr(0, rest.find('\0'));
    rest.remove_prefix(part.size() == rest.size() ? part.size() : part.size() + 1);
    return part;
  };
  const std::string_view node = next();
  const std::string_view ele = next();
  try {
    CHECK(parmesan::fuzz::has_right_indices(parmesan::parse_triangle_mesh(node, ele, rest, "fuzz")));
  } catch (const parmesan::FileError&) {
  }
  return 0;
}
