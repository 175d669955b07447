#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace parmesan {

/// Number of insertions, deletions and replacements of characters that turn a into b
/// (Levenshtein 1966). Cost: O(|a| |b|).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The allowed name closest to the one written; empty when none is close enough to be a slip
/// (half its length, at least 1) and not just one begins with it, of at least three letters. Ties go to the first. Case
/// does not count.
std::string nearest_name(std::string_view written, std::span<const std::string> allowed);

/// "; did you mean 'alpha'?" or nothing.
std::string suggestion(std::string_view written, std::span<const std::string> allowed);

/// The names in single quotes, separated by commas, in the order given; "(none)" when empty.
std::string quoted_list(std::span<const std::string> names);

}  // namespace parmesan
