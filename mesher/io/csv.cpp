#include "mesher/io/csv.h"

#include <cmath>
#include <string_view>

#include "mesher/number_text.h"

namespace parmesan {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

std::string safe_text(const std::string& text) {
  constexpr std::string_view formula_starts = "=+-@\t\r";
  const bool formula = !text.empty() && formula_starts.find(text.front()) != std::string_view::npos;
  const std::string safe = formula ? "'" + text : text;
  return safe.find_first_of(",\"\r\n") == std::string::npos ? safe : quoted(safe);
}

std::string cell_text(const CsvCell& cell) {
  if (const double* number = std::get_if<double>(&cell)) return std::isfinite(*number) ? text(*number) : "";
  if (const std::int64_t* number = std::get_if<std::int64_t>(&cell)) return std::to_string(*number);
  if (const std::string* words = std::get_if<std::string>(&cell)) return safe_text(*words);
  return "";
}

}  // namespace

std::string csv_line(const CsvRow& row) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) line += ',';
    line += cell_text(row[i]);
  }
  return line + '\n';
}

}  // namespace parmesan
