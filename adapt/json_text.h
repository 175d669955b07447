#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parmesan {

/// Where in the text of a JSON document something stands; byte offsets.
struct JsonPlace {
  std::size_t key = 0;    // the member's name, or the value itself where there is none
  std::size_t value = 0;  // first byte of the value
  bool found = false;     // false: this is the nearest parent that exists
};

/// Where the value with this JSON pointer stands. text must be valid JSON, comments allowed.
/// Cost: O(text), no memory.
JsonPlace locate(std::string_view text, std::string_view pointer);

/// A name that occurs twice in one object.
struct DuplicateKey {
  std::string pointer;
  std::size_t offset = 0;  // of the second one
};

/// Every repeated member name of a valid JSON text. Cost: O(text log text).
std::vector<DuplicateKey> find_duplicate_keys(std::string_view text);

/// 1-based; columns count characters (UTF-8), not bytes.
struct LineColumn {
  int line = 0;
  int column = 0;
};
LineColumn line_column(std::string_view text, std::size_t offset);

/// One step of a JSON pointer (RFC 6901), with ~ and / escaped.
std::string pointer_step(std::string_view key);

/// The steps of a JSON pointer, unescaped; nothing when it is not one.
std::optional<std::vector<std::string>> pointer_steps(std::string_view pointer);

}  // namespace parmesan
