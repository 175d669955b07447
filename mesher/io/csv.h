#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace parmesan {

/// A cell of a table: empty, a number or a text.
using CsvCell = std::variant<std::monostate, double, std::int64_t, std::string>;
using CsvRow = std::vector<CsvCell>;

/// The row as a line with line feed (RFC 4180). Numbers that are not finite become empty cells.
/// Texts are quoted where needed; one that a spreadsheet would run as a formula (it begins with
/// = + - @, a tab or a carriage return) gets a ' in front.
std::string csv_line(const CsvRow& row);

}  // namespace parmesan
