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

/// The first repeated member names of a valid JSON text, at most so many. Cost: O(text log text).
std::vector<DuplicateKey> find_duplicate_keys(std::string_view text, std::size_t most);

/// The bracket that opens the first value nested deeper than this. The text may be anything, so that it can be asked
/// before parsing; values that follow what is no JSON are not looked at for sure. Cost: O(text), no memory.
std::optional<std::size_t> find_nesting_beyond(std::string_view text, int most);

/// The name with which an object first has more than so many. The text may be anything, but not nested without limit.
/// Cost: O(text).
std::optional<std::size_t> find_names_beyond(std::string_view text, std::size_t most);

/// The first number of a text, otherwise valid JSON, that is too large for double precision. Cost: O(text).
std::optional<std::size_t> find_overflow(std::string_view text);

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
