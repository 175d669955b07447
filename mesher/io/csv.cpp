#include "mesher/io/csv.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace parmesan {
namespace {

template <class Number>
std::string number_text(Number value) {
  std::array<char, 32> buffer{};
  const char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return std::string(std::string_view(buffer.data(), static_cast<std::size_t>(end - buffer.data())));
}

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
  if (const double* number = std::get_if<double>(&cell)) return std::isfinite(*number) ? number_text(*number) : "";
  if (const std::int64_t* number = std::get_if<std::int64_t>(&cell)) return number_text(*number);
  if (const std::string* text = std::get_if<std::string>(&cell)) return safe_text(*text);
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
