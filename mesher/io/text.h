#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace parmesan {

/// The largest file that is read: 4 GiB.
inline constexpr std::uint64_t max_file_bytes = std::uint64_t{1} << 32;

/// The whole content of a regular file, but for the byte order mark of UTF-8, if it begins with one.
///
/// Errors: FileError when the file cannot be opened or read, is not a regular file (a folder, a
/// pipe, a device) or has more than max_bytes. Cost: one copy of the file.
std::string read_file(const std::string& path, std::uint64_t max_bytes = max_file_bytes);

/// Reads numbers and words from a text, and knows the line on which it stands.
///
/// Words are separated by blanks (spaces, tabs, line ends with or without carriage return); '#'
/// starts a comment that ends with its line; a UTF-8 byte order mark at the start is skipped.
/// The locale plays no part. A copy is a bookmark: it goes on from where the original stood.
/// Errors: every function throws FileError with the line, a FileValueError for numbers that are not finite and for
/// indices that are out of range; messages never quote the text, except
/// for characters that numbers are made of. The text must outlive the reader.
class TextReader {
 public:
  /// name: how messages call the text, usually its path.
  TextReader(std::string_view text, const std::string& name);

  /// Skips blanks and comments; true when nothing follows.
  bool at_end();

  /// Throws unless nothing follows. what: the last thing that could be there.
  void require_end(const char* what);

  /// Skips blanks and comments, but not the line's end; true when nothing follows on this line.
  bool at_line_end();

  /// Goes to the start of the next line.
  void skip_line();

  /// The byte of the text where the reader stands, and going to one: for files that are text in parts.
  std::size_t position() const { return static_cast<std::size_t>(position_ - text_.data()); }
  void seek(std::size_t position) { position_ = text_.data() + position; }

  /// The next word: up to a blank or '#', or a whole string in double quotes.
  std::string_view word(const char* what);

  /// Skips words up to the next one that begins with a letter and is not a number (nan, inf).
  void skip_to_keyword();

  /// what: how messages call the number, like "the x coordinate".
  int integer(const char* what);

  /// Finite numbers only. "1.5d-3" (Fortran) and "+1" are understood.
  double real(const char* what);

  /// A count of records of words_each words, which must fit into the rest of the text.
  int count(const char* what, int words_each);

  /// An index from base to base + size - 1, as 0 to size - 1.
  int index(const char* what, int base, int size);

  /// Throws FileError at the line where the last word, or a missing one, stands.
  [[noreturn]] void fail(const std::string& problem) const;

  /// The same with FileValueError.
  [[noreturn]] void fail_value(const std::string& problem) const;

 private:
  void skip_blanks();
  void start_word(const char* what);
  bool ends_word(const char* position) const;
  int line() const;  // of the last word
  [[noreturn]] void fail_number(const char* what, const char* wanted) const;
  double unusual_real(const char* what);

  std::string_view text_;
  const std::string* name_;
  const char* position_;
  const char* end_;
  const char* word_;  // where the last word began
};

/// The last part of a path from its last dot on, in lower case; empty when there is none.
std::string file_suffix(const std::string& path);

/// The path with its suffix replaced.
std::string with_suffix(const std::string& path, const std::string& suffix);

}  // namespace parmesan
