#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mesher/io/byte_reader.h"
#include "mesher/io/text.h"

namespace parmesan {

/// The words and numbers of a Gmsh file. The names of sections, and what is said so below, are always text; in a
/// binary file the other numbers are bytes, which begin on a new line.
/// Errors: every function throws FileError, with the line, or the byte where the numbers are bytes.
class MshInput {
 public:
  /// Reads the section MeshFormat. The bytes and the name must outlive the input.
  MshInput(std::string_view bytes, const std::string& name);

  bool is_binary() const { return is_binary_; }
  bool is_version_2() const { return is_version_2_; }

  // Always text.
  bool at_end() { return text_.at_end(); }
  std::string_view word(const char* what) { return text_.word(what); }
  int text_integer(const char* what) { return text_.integer(what); }
  double text_real(const char* what) { return text_.real(what); }

  /// Goes to a line that begins with this word, whatever stands before.
  void skip_to_line(const std::string& word);

  /// To be called around numbers that are bytes in a binary file: goes to the next line, and back to text.
  void start_numbers();
  void end_numbers();

  int integer(const char* what) { return is_binary_ ? bytes_.read<std::int32_t>(what) : text_.integer(what); }
  double real(const char* what) { return is_binary_ ? bytes_.real<double>(what) : text_.real(what); }

  /// A tag or a count: 64 bits, not negative.
  std::int64_t size(const char* what);

  /// A count of records of at least words_each numbers, which must fit into the rest of the file.
  std::size_t count(const char* what, std::size_t words_each) { return fitting(size(what), what, words_each); }
  std::size_t text_count(const char* what, std::size_t words_each);

  /// Throws at the last word or number, or at the name of the section.
  [[noreturn]] void fail(const std::string& problem) const;

  /// The same with FileValueError.
  [[noreturn]] void fail_value(const std::string& problem) const;

 private:
  void read_format();
  std::size_t fitting(std::int64_t value, const char* what, std::size_t words_each);

  std::string_view all_;
  TextReader text_;
  ByteReader bytes_;
  bool is_binary_ = false;
  bool is_version_2_ = false;
  bool in_bytes_ = false;  // between start_numbers and end_numbers of a binary file
};

}  // namespace parmesan
