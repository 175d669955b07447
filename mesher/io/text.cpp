#include "mesher/io/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

#include "mesher/errors.h"

namespace parmesan {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool is_part_of_number(char c) {
  return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == ',' || c == 'e' || c == 'E';
}

/// The word in quotes when it looks like a number, else what it is; at most 32 characters.
std::string describe(std::string_view word) {
  if (word.empty()) return "nothing";
  if (!std::all_of(word.begin(), word.end(), is_part_of_number)) return "something else";
  return "'" + std::string(word.substr(0, 32)) + (word.size() > 32 ? "...'" : "'");
}

/// nan, inf, or beyond double precision.
bool is_not_finite_number(std::string_view word) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return end == word.data() + word.size() && (error == std::errc::result_out_of_range || !std::isfinite(value));
}

}  // namespace

TextReader::TextReader(std::string_view text, const std::string& name)
    : text_(text), name_(&name), position_(text.data()), end_(text.data() + text.size()), word_(text.data()) {
  if (text.starts_with("\xef\xbb\xbf")) position_ += 3;
}

inline void TextReader::skip_blanks() {
  while (position_ != end_) {
    if (*position_ == '#') {
      position_ = std::find(position_, end_, '\n');
    } else if (!is_blank(*position_)) {
      return;
    } else {
      ++position_;
    }
  }
}

inline bool TextReader::ends_word(const char* position) const {
  return position == end_ || is_blank(*position) || *position == '#';
}

bool TextReader::at_end() {
  skip_blanks();
  return position_ == end_;
}

void TextReader::require_end(const char* what) {
  if (at_end()) return;
  word_ = position_;
  fail(std::string("more follows after ") + what + "; is a count too small?");
}

bool TextReader::at_line_end() {
  while (position_ != end_ && *position_ != '\n' && is_blank(*position_)) ++position_;
  return position_ == end_ || *position_ == '\n' || *position_ == '#';
}

void TextReader::skip_line() {
  position_ = std::find(position_, end_, '\n');
  if (position_ != end_) ++position_;
}

inline void TextReader::start_word(const char* what) {
  skip_blanks();
  word_ = position_;
  if (position_ == end_) fail(std::string("the file ends where ") + what + " should be; is it cut off?");
}

std::string_view TextReader::word(const char* what) {
  start_word(what);
  if (*position_ == '"') {
    const char* closing = std::find(position_ + 1, end_, '"');
    if (closing == end_) fail(std::string("no closing quote of ") + what);
    position_ = closing + 1;
  } else {
    while (!ends_word(position_)) ++position_;
  }
  return {word_, static_cast<std::size_t>(position_ - word_)};
}

void TextReader::skip_to_keyword() {
  while (!at_end()) {
    const char* start = position_;
    const std::string_view next = word("a word");
    if (is_letter(next.front()) && !is_not_finite_number(next)) {
      position_ = start;
      return;
    }
  }
}

int TextReader::integer(const char* what) {
  start_word(what);
  // The usual case, faster than from_chars: up to 9 digits, which cannot overflow.
  const char* digit = position_;
  const char* last = position_ + std::min<std::ptrdiff_t>(9, end_ - position_);
  int value = 0;
  while (digit != last && *digit >= '0' && *digit <= '9') value = 10 * value + (*digit++ - '0');
  if (digit != position_ && ends_word(digit)) {
    position_ = digit;
    return value;
  }
  const bool plus = end_ - position_ > 1 && position_[0] == '+' && position_[1] != '-';
  const char* begin = position_ + (plus ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, end_, value);
  if (error != std::errc() || !ends_word(end)) fail_number(what, "a whole number within 32 bits");
  position_ = end;
  return value;
}

double TextReader::real(const char* what) {
  start_word(what);
  double value = 0.0;
  const auto [end, error] = std::from_chars(position_, end_, value);
  if (error != std::errc() || !ends_word(end) || !std::isfinite(value)) return unusual_real(what);
  position_ = end;
  return value;
}

/// Tries again without a leading plus and with Fortran's exponent letter D replaced.
double TextReader::unusual_real(const char* what) {
  std::string text(word(what).substr(0, 64));
  if (text.starts_with('+') && !text.starts_with("+-")) text.erase(0, 1);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
  double value = 0.0;
  const char* text_end = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), text_end, value);
  if (error != std::errc() || end != text_end || !std::isfinite(value)) fail_number(what, "a finite number");
  return value;
}

int TextReader::count(const char* what, int words_each) {
  const int value = integer(what);
  if (value < 0) fail(std::string(what) + " is negative");
  const std::int64_t least_bytes = 2 * static_cast<std::int64_t>(value) * words_each;  // a blank before each word
  if (least_bytes > end_ - position_) fail(std::string(what) + " is larger than the file can hold; is it cut off?");
  return value;
}

int TextReader::index(const char* what, int base, int size) {
  const int value = integer(what);
  if (value < base || value - base >= size) {
    const std::string allowed = size == 0 ? "there are none"
                                          : "must be from " + std::to_string(base) + " to " +
                                                std::to_string(static_cast<std::int64_t>(base) + size - 1);
    fail_value(std::string(what) + " is " + std::to_string(value) + ", " + allowed);
  }
  return value - base;
}

int TextReader::line() const { return 1 + static_cast<int>(std::count(text_.data(), word_, '\n')); }

void TextReader::fail(const std::string& problem) const { throw FileError(*name_, line(), problem); }

void TextReader::fail_value(const std::string& problem) const { throw FileValueError(*name_, line(), problem); }

void TextReader::fail_number(const char* what, const char* wanted) const {
  const char* end = word_;
  while (!ends_word(end)) ++end;
  const std::string_view found(word_, static_cast<std::size_t>(end - word_));
  const bool comma = found.find(',') != std::string_view::npos;
  const std::string problem = std::string(what) + " must be " + wanted + ", found " + describe(found) +
                              (comma ? "; the decimal mark is a point" : "");
  is_not_finite_number(found) ? fail_value(problem) : fail(problem);
}

std::string file_suffix(const std::string& path) {
  const std::size_t name = path.find_last_of('/') + 1;
  const std::size_t dot = path.find_last_of('.');
  if (dot == std::string::npos || dot < name) return "";
  std::string suffix = path.substr(dot);
  for (char& c : suffix) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return suffix;
}

std::string with_suffix(const std::string& path, const std::string& suffix) {
  return path.substr(0, path.size() - file_suffix(path).size()) + suffix;
}

}  // namespace parmesan
